// The two interfaces of the shadow system. A technique is stateless and pure: it says what it would
// do for a pair. A job is one technique at work for one light: it owns everything kept between
// frames, and dies when no plan names it any more.
//
// This header is read on both sides of the wall, so it names GPU types without knowing them.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/world.hpp"
#include "systems/shadows/pairs.hpp"
#include "systems/shadows/plan.hpp"
#include "systems/shadows/remedies.hpp"
#include "systems/shadows/resolution.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace gpu {
class Frame;
class ShaderLibrary;
} // namespace gpu
namespace render {
struct Geometry;
struct VisibilityTarget;
} // namespace render
namespace trace {
class TraceScene;
}

namespace shadows {

struct TechniqueTraits {
    std::string_view name;      ///< its spelling everywhere: Lua, plans.json, captures, charts
    std::string_view about;     ///< one line for people
    bool picked_by_auto = true; ///< false: only when someone names it
};

/// What a job serves this frame.
struct ShadowRequest {
    const scene::World& world; ///< where the scene was taken from; for vertices alone
    const ShadowScene& scene;
    std::uint32_t light = 0;             ///< index into scene.lights
    std::span<const CasterGroup> groups; ///< of the light
    std::span<const Plan* const> plans;  ///< the light's plans that name this job's technique
    std::uint32_t receiver_end = 0;      ///< one past the highest receiver id
    bool serves_all = false;       ///< nothing that this light can darken is served by another job
    const scene::ShadowWish& wish; ///< scene, light and overriding wishes
    const Remedies& remedies;
    const std::function<const trace::TraceScene&()>&
        truth; ///< ray queries, built by the first call of a frame
};

/// One technique at work for one light.
class ShadowJob {
public:
    virtual ~ShadowJob() = default;

    /// CPU, per refresh: fits, silhouettes.
    virtual engine::Result<void> update(const ShadowRequest& request) = 0;
    /// Whether what was last drawn still serves the camera of this frame, nothing else having
    /// changed. @pre update() was called
    [[nodiscard]] virtual bool still_serves(const ShadowRequest& request) const {
        static_cast<void>(request);
        return true;
    }
    /// Whether what was drawn may serve for some frames after things have moved, as if they had
    /// not: a refresh period is for these. Others follow every motion.
    [[nodiscard]] virtual bool may_wait() const { return false; }
    /// GPU, per refresh: draws maps and textures, and fetches what apply() needs.
    /// Errors: a shader that does not compile.
    virtual engine::Result<void>
    render(gpu::Frame& frame, gpu::ShaderLibrary& shaders, const render::Geometry& geometry) = 0;
    /// GPU, each frame: lowers the mask where its receivers are.
    virtual void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) = 0;
    /// Whether apply() works with the stencil.
    [[nodiscard]] virtual bool needs_stencil() const { return false; }
    /// How coarse the mask is at a point that the job serves. @pre update() was called
    [[nodiscard]] virtual Resolution
    resolution(const scene::CameraView& camera, const SurfacePoint& point) const {
        static_cast<void>(camera);
        static_cast<void>(point);
        return {};
    }
    /// Device memory that the job holds, for stats.json.
    [[nodiscard]] virtual std::size_t gpu_bytes() const { return 0; }
};

/// Makes jobs of one kind.
class ShadowTechnique {
public:
    virtual ~ShadowTechnique() = default;

    [[nodiscard]] virtual const TechniqueTraits& traits() const = 0;
    /// Pure: same pair, same answer; no OpenGL. Errors: why this pair is outside the technique's
    /// domain.
    [[nodiscard]] virtual engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const = 0;
    /// Null for a technique that does nothing.
    [[nodiscard]] virtual std::unique_ptr<ShadowJob> start() const = 0;
};

using Techniques = std::vector<std::unique_ptr<ShadowTechnique>>;

} // namespace shadows
