#include "systems/shadows/caster_groups.hpp"

#include "systems/shadows/pairs.hpp"

#include <algorithm>
#include <span>

namespace shadows {

namespace {

/// Enough casters to be worth a group of their own; smaller clusters cost more decisions than they
/// save.
constexpr std::size_t kSmallestCluster = 8;

/// Casters as large as half of everything stand alone: in a cluster their bounds would be its
/// bounds.
constexpr double kLargeShare = 0.5;
constexpr std::size_t kMostLarge = 16;

CasterGroup make_group(const ShadowScene& scene, std::span<const std::uint32_t> casters) {
    CasterGroup group;
    group.casters.assign(casters.begin(), casters.end());
    std::sort(group.casters.begin(), group.casters.end());
    for (const std::uint32_t index : casters) {
        const CasterView& caster = scene.casters[index];
        group.bounds.grow(caster.bounds);
        group.largest_radius =
            std::max(group.largest_radius, glm::length(caster.bounds.extent()) * 0.5);
        group.triangles += caster.triangles;
        group.hero = group.hero || caster.hero;
    }
    return group;
}

/// Halves `casters` at the median of the longest side of their centres until `room` groups are used
/// up.
void cluster(
    const ShadowScene& scene,
    std::span<std::uint32_t> casters,
    std::size_t room,
    std::vector<CasterGroup>& groups) {
    if (room < 2 || casters.size() < 2 * kSmallestCluster) {
        groups.push_back(make_group(scene, casters));
        return;
    }
    engine::WorldAabb centres;
    for (const std::uint32_t index : casters)
        centres.grow(scene.casters[index].bounds.centre());
    const glm::dvec3 extent = centres.extent();
    int axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    std::sort(casters.begin(), casters.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double at_a = scene.casters[a].bounds.centre()[axis];
        const double at_b = scene.casters[b].bounds.centre()[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    const std::size_t half = casters.size() / 2;
    cluster(scene, casters.first(half), room / 2, groups);
    cluster(scene, casters.subspan(half), room - room / 2, groups);
}

/// Moves the large ones of `casters` to the end and returns their number.
std::size_t part_large(const ShadowScene& scene, std::vector<std::uint32_t>& casters) {
    engine::WorldAabb all;
    for (const std::uint32_t index : casters)
        all.grow(scene.casters[index].bounds);
    const double limit = kLargeShare * glm::length(all.extent());
    const auto large =
        std::stable_partition(casters.begin(), casters.end(), [&](std::uint32_t index) {
            return glm::length(scene.casters[index].bounds.extent()) < limit;
        });
    const auto count = static_cast<std::size_t>(casters.end() - large);
    return count < casters.size() && count <= kMostLarge ? count : 0;
}

} // namespace

std::vector<CasterGroup> group_casters(const ShadowScene& scene, const LightView& light) {
    std::vector<std::uint32_t> heroes;
    std::vector<std::uint32_t> others;
    for (std::uint32_t index = 0; index < scene.casters.size(); ++index) {
        const CasterView& caster = scene.casters[index];
        if (can_reach(light, caster.bounds)) (caster.hero ? heroes : others).push_back(index);
    }
    std::vector<CasterGroup> groups;
    const std::size_t large = part_large(scene, others);
    const std::size_t room = kMaxGroupsPerLight - large - (others.empty() ? 0 : 1);
    const std::size_t alone = heroes.size() <= room ? heroes.size() : room - 1;
    const std::span<std::uint32_t> all(heroes);
    for (std::size_t i = 0; i < alone; ++i)
        groups.push_back(make_group(scene, all.subspan(i, 1)));
    if (alone < heroes.size()) groups.push_back(make_group(scene, all.subspan(alone)));
    const std::span<std::uint32_t> rest(others);
    for (std::size_t i = rest.size() - large; i < rest.size(); ++i)
        groups.push_back(make_group(scene, rest.subspan(i, 1)));
    if (!others.empty())
        cluster(scene, rest.first(rest.size() - large), kMaxGroupsPerLight - groups.size(), groups);
    return groups;
}

} // namespace shadows
