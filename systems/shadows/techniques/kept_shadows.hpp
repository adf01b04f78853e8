// Which planar shadows are kept as textures of their receivers, and whether what is kept is still
// right. A shadow is taken to stand still until its casters, its light or its receiver move soon
// after it was drawn; then it is projected anew in each frame until it has been still for a while.

#pragma once

#include "systems/shadows/planar_casters.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/plane_texture.hpp"

#include <map>
#include <string>
#include <vector>

namespace shadows {

/// All that a kept shadow depends on; equal values, equal texture.
struct KeptFrom {
    struct Placed {
        std::uint32_t entity = 0;
        glm::dmat4 world_from_mesh = glm::dmat4(1.0);
        bool operator==(const Placed&) const = default;
    };
    std::vector<Placed> casters;
    std::uint64_t poses = 0; ///< version of the deformed ones; 0 without any
    scene::LightKind kind = scene::LightKind::directional;
    glm::dvec3 light_position = {};
    glm::vec3 light_direction = {};
    float light_size = 0.0F; ///< radius or angular radius
    std::size_t samples = 1;
    std::size_t boxes = 0;
    PlaneRectangle rectangle;

    bool operator==(const KeptFrom&) const = default;
};

KeptFrom
kept_from(const ShadowRequest& request, const PlanEntry& entry, const PlanarCasters& casters);

/// The shadow on one receiver.
class KeptShadow {
public:
    /// A frame's view of it. @param size texels wanted
    void follow(KeptFrom from, const glm::ivec2& size, const Remedies& remedies);
    /// Whether it has stood still long enough to be worth a texture.
    [[nodiscard]] bool still() const { return restless_frames_ == 0; }
    /// Whether its texels are neither too large nor four times as many as are wanted.
    [[nodiscard]] bool fits(const glm::ivec2& size) const;

    engine::Result<void> prepare(const std::string& label);
    /// Draws the texture where it is not right any more. No pass is open.
    void refresh(
        gpu::Frame& frame,
        const PlanarDraws& draws,
        const PlanarDraws::Runs& runs,
        std::span<const PlanarSample> samples);
    /// Called once for each frame in which the shadow is seen.
    void pass_frame();

    [[nodiscard]] const PlaneTexture& texture() const { return texture_; }

private:
    KeptFrom from_;
    Remedies remedies_;
    glm::ivec2 size_ = {};
    PlaneTexture texture_;
    bool due_ = true;
    int served_frames_ = 0;
    int restless_frames_ = 0;
};

} // namespace shadows
