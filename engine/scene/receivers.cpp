#include "engine/scene/receivers.hpp"

#include "engine/core/check.hpp"

#include <algorithm>

namespace scene {

ReceiverTable::ReceiverTable(const World& world) {
    std::size_t total = 1;
    world.registry.each<MeshInstance>([&](ecs::Entity entity, const MeshInstance& instance) {
        const auto patches = world.assets.meshes[instance.mesh].patches.size();
        ranges_.push_back({entity, 0, static_cast<std::uint32_t>(1 + patches)});
        total += 1 + patches;
    });
    CHECK_LT(ranges_.size(), kMaxReceivers);
    std::sort(ranges_.begin(), ranges_.end(), [](const ReceiverRange& a, const ReceiverRange& b) {
        return a.entity < b.entity;
    });
    const bool with_patches = total <= kMaxReceivers;
    for (ReceiverRange& range : ranges_) {
        if (!with_patches) range.count = 1;
        range.first = end_;
        end_ += range.count;
    }
}

ReceiverPart ReceiverTable::part(std::uint32_t id) const {
    CHECK_GT(id, kNoReceiver);
    CHECK_LT(id, end_);
    const auto after = std::upper_bound(
        ranges_.begin(), ranges_.end(), id, [](std::uint32_t value, const ReceiverRange& range) {
            return value < range.first;
        });
    const ReceiverRange& range = *std::prev(after);
    return {range.entity, id - range.first};
}

const ReceiverRange* ReceiverTable::find(ecs::Entity entity) const {
    const auto found = std::lower_bound(
        ranges_.begin(), ranges_.end(), entity, [](const ReceiverRange& range, ecs::Entity value) {
            return range.entity < value;
        });
    return found != ranges_.end() && found->entity == entity ? &*found : nullptr;
}

} // namespace scene
