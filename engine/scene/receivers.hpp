// Receiver ids: one number for every flat patch of every mesh in a world, and one for the rest of
// each mesh. The G-buffer writes them, plans name them, truth is compared by them.

#pragma once

#include "ecs/entity.hpp"
#include "engine/scene/world.hpp"

#include <cstdint>
#include <vector>

namespace scene {

/// The id of pixels that show nothing.
inline constexpr std::uint32_t kNoReceiver = 0;
/// Ids have 20 bits in the packed G-buffer.
inline constexpr std::uint32_t kMaxReceivers = 1U << 20U;

/// The ids of one entity: `first` is the rest of the mesh, `first + k` its patch k (1-based).
struct ReceiverRange {
    ecs::Entity entity;
    std::uint32_t first = 0;
    std::uint32_t count =
        0; ///< 1 + number of patches; 1 when ids run short and patches are given up
};

/// One part of a mesh: what a receiver id stands for.
struct ReceiverPart {
    ecs::Entity entity;
    std::uint32_t patch = 0; ///< 0 is the rest, k is Mesh::patches[k - 1]
};

/// All ids of a world, in the order of its entities' numbers, so that the same world gives the same
/// ids.
class ReceiverTable {
public:
    ReceiverTable() = default;
    explicit ReceiverTable(const World& world);

    [[nodiscard]] const std::vector<ReceiverRange>& ranges() const { return ranges_; }
    /// One past the highest id in use.
    [[nodiscard]] std::uint32_t end() const { return end_; }
    /// @pre kNoReceiver < id < end()
    [[nodiscard]] ReceiverPart part(std::uint32_t id) const;
    /// The range of an entity, or null when it has no mesh.
    [[nodiscard]] const ReceiverRange* find(ecs::Entity entity) const;

private:
    std::vector<ReceiverRange> ranges_; ///< sorted by first and by entity alike
    std::uint32_t end_ = 1;
};

} // namespace scene
