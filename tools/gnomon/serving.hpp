// Which technique serves which pixel of a picture, and how coarse it is there.

#pragma once

#include "systems/shadows/shadow_system.hpp"

#include <string>
#include <unordered_map>
#include <vector>

#include "tools/gnomon/comparing.hpp"

namespace gnomon {

/// The plans of one light in the last prepared frame; dies before the next one.
class Serving {
public:
    /// @param light index into the frame's lights
    Serving(const shadows::ShadowSystem& shadows, std::size_t light);

    /// How far from a true edge each pixel may be wrong, px: by the coarsest technique that serves
    /// its receiver; 1 where none has a grid of its own.
    [[nodiscard]] std::vector<float> bands_px(
        const DrawnSurfaces& drawn,
        const truth::TruthImage& truth,
        const scene::CameraView& camera) const;

    /// "planar 62 %, cascaded_map 38 %": shares of the valid pixels. "unpaired" is what nothing can
    /// darken.
    [[nodiscard]] std::string
    shares(const DrawnSurfaces& drawn, const measure::Comparison& comparison) const;

private:
    struct Server {
        std::string techniques; ///< joined by "+"
        std::vector<const shadows::ShadowJob*> jobs;
    };

    std::unordered_map<std::uint32_t, Server> by_receiver_;
};

} // namespace gnomon
