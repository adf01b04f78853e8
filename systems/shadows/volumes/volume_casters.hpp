// The casters of one light's volumes, and what is kept of each from refresh to refresh: the surface
// of its mesh for good, its volume until light, pose or place change. A caster of which a proxy
// serves some receivers and the mesh itself others is here twice.

#pragma once

#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/volumes/layered_surfaces.hpp"
#include "systems/shadows/volumes/shadow_volume.hpp"
#include "systems/shadows/volumes/swept_bounds.hpp"
#include "systems/shadows/volumes/volume_tasks.hpp"

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace shadows {

/// One caster of a frame, or one of its proxies.
struct VolumeCaster {
    std::uint32_t entity = 0; ///< its value
    int level = 0;            ///< of the proxy; 0: the caster itself
    std::size_t piece = 0;    ///< of its surface
    std::size_t pass = 0;     ///< index into VolumeCasters::passes()
    const ShadowVolume* volume = nullptr;
    const std::vector<glm::vec3>* positions = nullptr; ///< that the volume was built from
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

    /// Pass by pass, in the order of ShadowScene::casters.
    [[nodiscard]] const std::vector<VolumeCaster>& all() const { return casters_; }
    /// For each pass the ids of the receivers that its casters may darken, rising. Casters
    /// themselves are in the first; a proxy is with others that may darken the same receivers.
    [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& passes() const { return passes_; }
    /// Of all volumes, one after the other.
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }
    /// Whether indices() are others than at the last call.
    [[nodiscard]] bool take_changed() { return std::exchange(changed_, false); }
    /// Volumes built by the last update.
    [[nodiscard]] std::size_t built_count() const { return built_count_; }

private:
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
        std::vector<glm::vec3> positions; ///< of the mesh, as posed
        ShadowVolume volume;
    };

    using LevelKey = std::pair<std::uint32_t, int>; ///< mesh, and level
    /// An entity, its level, and which of its surface's pieces.
    using VolumeKey = std::tuple<std::uint32_t, int, std::size_t>;

    const std::vector<LayeredSurface>&
    surfaces_of(const ShadowRequest& request, std::uint32_t mesh, int level);
    void add(const ShadowRequest& request, const VolumeTask& task, std::size_t pass);
    const Kept& kept_of(
        const ShadowRequest& request,
        const CasterView& view,
        const VolumeKey& key,
        const CasterSurface& surface,
        const BuiltFrom& from);
    void gather_indices();

    VolumeBuilder builder_;
    Remedies remedies_;
    std::map<LevelKey, std::vector<LayeredSurface>> surfaces_;
    std::map<VolumeKey, Kept> kept_;
    std::vector<VolumeCaster> casters_;
    std::vector<std::vector<std::uint32_t>> passes_;
    std::vector<std::uint32_t> indices_;
    bool changed_ = false;
    std::size_t built_count_ = 0;
};

} // namespace shadows
