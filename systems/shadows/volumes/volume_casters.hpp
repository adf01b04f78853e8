// The casters of one light's volumes, and what is kept of each from refresh to refresh: the surface
// of its mesh for good, its volume until light, pose or place change.

#pragma once

#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/volumes/shadow_volume.hpp"
#include "systems/shadows/volumes/swept_bounds.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace shadows {

/// One caster of a frame.
struct VolumeCaster {
    std::uint32_t entity = 0; ///< its value
    const ShadowVolume* volume = nullptr;
    std::uint32_t first_index = 0; ///< of the volume in VolumeCasters::indices()
    glm::dmat4 world_from_mesh = glm::dmat4(1.0);
    glm::dvec4 light_mesh = {}; ///< as VolumeBuilder has it
    engine::WorldAabb bounds;
    bool mirrored = false;
    bool shows_through = false;      ///< something may be seen through a cap that faces the light
    int layers = 1;                  ///< most volumes that one pixel may be in
    std::vector<SweptReach> reaches; ///< one per receiver that it may darken
};

class VolumeCasters {
public:
    /// Follows a frame: builds the volumes that are new or whose caster or light has moved.
    void update(const ShadowRequest& request);

    /// In the order of ShadowScene::casters.
    [[nodiscard]] const std::vector<VolumeCaster>& all() const { return casters_; }
    /// Of all volumes, one after the other.
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }
    /// Whether indices() are others than at the last call.
    [[nodiscard]] bool take_changed() { return std::exchange(changed_, false); }
    /// Volumes built by the last update.
    [[nodiscard]] std::size_t built_count() const { return built_count_; }

private:
    struct Surface {
        CasterSurface surface;
        bool open = false; ///< some of it, or some is wound the wrong way round
        int layers = 0;
    };
    /// What a volume was built from; equal values, equal volume.
    struct BuiltFrom {
        std::uint32_t mesh = 0;
        std::uint64_t pose_version = 0;
        glm::dvec4 light_mesh = {};
        bool surrounded = false;
        bool operator==(const BuiltFrom&) const = default;
    };
    struct Kept {
        BuiltFrom from;
        ShadowVolume volume;
    };

    const Surface& surface_of(const ShadowRequest& request, std::uint32_t mesh);
    void add(const ShadowRequest& request, const CasterView& view, std::vector<SweptReach> reaches);
    void gather_indices();

    VolumeBuilder builder_;
    Remedies remedies_;
    std::map<std::uint32_t, Surface> surfaces_; ///< by mesh
    std::map<std::uint32_t, Kept> kept_;        ///< by entity
    std::vector<VolumeCaster> casters_;
    std::vector<std::uint32_t> indices_;
    bool changed_ = false;
    std::size_t built_count_ = 0;
};

} // namespace shadows
