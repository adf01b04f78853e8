#include "systems/shadows/volumes/caster_proxy.hpp"

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/maps/map_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace shadows {

namespace {

/// Metres between two boxes; 0 when they meet.
double gap(const engine::WorldAabb& a, const engine::WorldAabb& b) {
    return glm::length(glm::max(glm::max(a.min - b.max, b.min - a.max), glm::dvec3(0.0)));
}

/// Whether the box of the caster's vertices lies before or behind a flat receiver, as far as
/// rounding lets one tell.
bool on_one_side(const CasterView& caster, const ReceiverView& receiver) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner(glm::dvec3(caster.bounds_mesh.corner(i)), 1.0);
        const double height = glm::dot(receiver.normal, glm::dvec3(caster.world_from_mesh * corner))
                              - receiver.offset;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    const double rounding = 1e-6 * glm::length(caster.bounds.extent());
    return lowest >= receiver.residual - rounding || highest <= rounding - receiver.residual;
}

bool surrounds_lamp(const CasterView& caster, const LightView& light) {
    return light.light.kind != scene::LightKind::directional
           && caster.bounds.contains(light.position);
}

} // namespace

bool proxy_may_serve(const CasterView& caster, int level, const ReceiverView& receiver) {
    if (receiver.entity == caster.id) return false;
    const double deviation = caster.proxies[static_cast<std::size_t>(level - 1)].deviation;
    return gap(caster.bounds, receiver.bounds) > deviation
           || (receiver.flat && on_one_side(caster, receiver));
}

double proxy_error_px(
    const PairView& pair, const CasterGroup& casters, const CasterView& caster, int level) {
    const double deviation = caster.proxies[static_cast<std::size_t>(level - 1)].deviation;
    return length_px(pair, deviation * magnification(pair, casters));
}

int proxy_level(
    const PairView& pair,
    const CasterGroup& casters,
    const CasterView& caster,
    double allowance_px) {
    if (surrounds_lamp(caster, pair.light)) return 0;
    const bool asked = pair.wish.proxy.has_value();
    int level = caster.proxy_count();
    if (asked) level = std::min(level, *pair.wish.proxy);
    for (; level > 0; --level)
        if (proxy_may_serve(caster, level, pair.receiver)
            && (asked || proxy_error_px(pair, casters, caster, level) <= allowance_px))
            return level;
    return 0;
}

std::string why_not_proxy(const PairView& pair, const CasterView& caster, int level) {
    if (level == *pair.wish.proxy) return {};
    if (caster.deforms)
        return fmt::format("'{}' itself: how far a proxy is off is unknown in a pose", caster.name);
    if (!caster.closed) return fmt::format("'{}' itself: it is not closed", caster.name);
    if (caster.proxy_count() == 0)
        return fmt::format("'{}' itself: only heroes of 256 triangles have proxies", caster.name);
    if (pair.receiver.entity == caster.id)
        return fmt::format("'{}' itself: it is its own receiver", caster.name);
    if (surrounds_lamp(caster, pair.light))
        return fmt::format("'{}' itself: the lamp may be inside it", caster.name);
    if (level < std::min(*pair.wish.proxy, caster.proxy_count()))
        return fmt::format("'{}' at level {}: the receiver is too near", caster.name, level);
    return fmt::format("'{}' at level {}: it has no more", caster.name, level);
}

} // namespace shadows
