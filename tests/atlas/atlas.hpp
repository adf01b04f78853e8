// The atlas of failures: every way in which a technique is known to go wrong, as a scene with one
// parameter that is swept through the failure. Each case names the remedy that keeps the failure
// away; a remedy is worth nothing unless the picture is wrong without it.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/scene/camera.hpp"
#include "systems/shadows/remedies.hpp"

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tools/gnomon/level.hpp"
#include "tools/measure/figures.hpp"
#include "tools/measure/motion.hpp"
#include "tools/truth/truth.hpp"

namespace atlas {

/// Pictures are square: pixels a side.
inline constexpr int kPictureSize = 256;

/// A case at one value of its parameter.
struct Stage {
    gnomon::Level level; ///< with the technique pinned
    scene::CameraView camera;
    std::string light;         ///< whose mask is measured
    bool wraps_stencil = true; ///< false: as on a driver that does not
    /// Of what moves: takes it to a frame of a sequence. None: it is a still.
    std::function<void(Stage&, int frame)> move = {};
};

/// One measured picture.
struct Observation {
    gpu::Counters counters; ///< of the frame
    measure::Comparison comparison;
    measure::Figures figures;                     ///< of the comparison
    std::optional<measure::MotionFigures> motion; ///< of a stage that moves
};

/// A promise about a picture: a figure that stays at or below a limit.
struct Gate {
    std::string figure; ///< as people read it: "false shadow inside, px"
    std::function<double(const Observation&)> value;
    double at_most = 0.0;
};

/// The values of the parameter.
struct Sweep {
    double from = 0.0;
    double to = 1.0;
    double worst = 0.5; ///< where the failure shows most
};

struct Case {
    std::string id;       ///< "P3"
    std::string sentence; ///< what goes wrong
    std::function<Stage(double)> build;
    Sweep sweep;
    std::optional<shadows::Remedy>
        remedy;              ///< what keeps it away; none: the technique's nature does
    std::vector<Gate> gates; ///< all hold with the remedy; one breaks without it at the worst step
};

/// A known failure that nothing here can show.
struct Impossible {
    std::string id;
    std::string sentence; ///< what goes wrong elsewhere
    std::string why;      ///< it cannot here
};

/// A technique that is asked for what it cannot do, and says so instead of drawing it.
struct Refusal {
    std::string id;       ///< of the failure that is refused
    std::string sentence; ///< what would go wrong
    std::string technique;
    std::function<Stage()> build; ///< with the technique pinned
    std::string reason;           ///< what it must say, or a part of that
};

/// What GoogleTest says of a case.
inline void PrintTo(const Case& one, std::ostream* out) {
    *out << one.id;
}

/// What GoogleTest says of a refusal.
inline void PrintTo(const Refusal& one, std::ostream* out) {
    *out << one.id << " by " << one.technique;
}

/// The visibility of the stage's light by rays; poses the stage.
/// Errors: no such light.
engine::Result<truth::TruthImage> trace(Stage& stage);

/// Draws a stage and compares it with the truth.
/// @param truth of trace()
/// @param pictures stem of the files mask, truth and error that are left in the folder of
/// GNOMON_ATLAS_PICTURES, where that is set
/// Errors: no OpenGL here, or a technique that does not serve what it is pinned to.
engine::Result<Observation> observe(
    Stage& stage,
    const truth::TruthImage& truth,
    const shadows::Remedies& remedies,
    const std::string& pictures);

/// The same with a truth of its own.
engine::Result<Observation>
observe(Stage& stage, const shadows::Remedies& remedies, const std::string& pictures);

/// A mask as a picture.
engine::Image grey(const measure::Mask& mask);

/// The gates that an observation breaks, one sentence each; empty when all hold.
std::vector<std::string> broken_gates(const Case& one, const Observation& seen);

/// Gates that several cases share.
Gate no_false_shadow_inside();
Gate no_light_leak_inside();
Gate largest_error_inside(double at_most_px);
/// Wrong pixels against what a shift of 1/16 px of every edge would make.
Gate wrong_over_precision_floor(double at_most);
/// Wrong visibility over the length of true edges.
Gate eps_at_most(double px);
/// What a technique that is exact but for its edges promises.
std::vector<Gate> exact_shape();

/// A stage whose receivers are traced but for one model, which the technique serves.
Stage pinned_stage(
    scene::World world,
    const scene::CameraView& camera,
    const std::string& light,
    const std::string& receiver,
    const std::string& technique);

} // namespace atlas
