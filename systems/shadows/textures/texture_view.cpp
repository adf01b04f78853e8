#include "systems/shadows/textures/texture_view.hpp"

#include "systems/shadows/maps/cascade_fit.hpp"
#include "systems/shadows/maps/local_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadows {

namespace {

/// Room before and behind the casters, of their depth: what lies at a depth of 0 counts as nothing.
constexpr double kDepthRoom = 1e-3;
/// The least side of a texture, metres: casters that the light sees edge on.
constexpr double kLeastSide = 1e-6;

struct Box {
    glm::dvec3 min = glm::dvec3(std::numeric_limits<double>::infinity());
    glm::dvec3 max = -min;

    void grow(const glm::dmat3& axes, const engine::WorldAabb& box) {
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner = axes * box.corner(i);
            min = glm::min(min, corner);
            max = glm::max(max, corner);
        }
    }
};

ParallelView parallel_view(
    const LightView& light,
    std::span<const engine::WorldAabb> casters,
    const engine::WorldAabb& behind,
    int size,
    int border,
    const Remedies& remedies) {
    ParallelView view;
    view.light_from_world = light_axes(glm::dvec3(light.direction), std::nullopt, remedies);
    view.size = size;
    Box held;
    for (const engine::WorldAabb& box : casters)
        held.grow(view.light_from_world, box);
    Box deep = held;
    if (!behind.empty()) deep.grow(view.light_from_world, behind);
    const glm::dvec2 side = glm::max(glm::dvec2(held.max - held.min), kLeastSide);
    view.texel = side / (size - 2.0 * border);
    view.min = glm::dvec2(held.min) - view.texel * static_cast<double>(border);
    const double room = kDepthRoom * std::max(deep.max.z - held.min.z, kLeastSide);
    view.nearest = held.min.z - room;
    view.farthest = deep.max.z + room;
    return view;
}

/// The light as a spot whose cone is just wide enough for the casters.
engine::Result<LightView>
turned_to(const LightView& light, std::span<const engine::WorldAabb> casters) {
    engine::WorldAabb all;
    for (const engine::WorldAabb& box : casters)
        all.grow(box);
    if (all.contains(light.position)) return engine::Error{"the lamp is amid the casters"};
    LightView spot = light;
    spot.direction = glm::vec3(glm::normalize(all.centre() - light.position));
    double least_cosine = 1.0;
    for (const engine::WorldAabb& box : casters)
        for (int i = 0; i < 8; ++i)
            least_cosine = std::min(
                least_cosine,
                glm::dot(
                    glm::dvec3(spot.direction), glm::normalize(box.corner(i) - light.position)));
    const double angle = std::acos(least_cosine);
    if (angle > kWidestTexture)
        return engine::Error{fmt::format(
            "seen from the lamp the casters reach {:.0f} degrees to each side, more than {:.0f}",
            glm::degrees(angle),
            glm::degrees(kWidestTexture))};
    spot.light.outer_angle = static_cast<float>(angle);
    return spot;
}

} // namespace

engine::Result<TextureView> fit_texture(
    const LightView& light,
    std::span<const engine::WorldAabb> casters,
    const engine::WorldAabb& behind,
    int size,
    int border,
    const Remedies& remedies) {
    if (light.light.kind == scene::LightKind::directional)
        return TextureView(parallel_view(light, casters, behind, size, border, remedies));
    if (light.light.kind == scene::LightKind::spot
        && static_cast<double>(light.light.outer_angle) <= kWidestSpot)
        return TextureView(spot_view(light, casters, size, border));
    const auto spot = turned_to(light, casters);
    if (!spot) return spot.error();
    return TextureView(spot_view(*spot, casters, size, border));
}

glm::dmat4 map_from_world(const TextureView& view) {
    return std::visit([](const auto& one) { return one.map_from_world(); }, view);
}

bool holds(const TextureView& view, const glm::dvec3& point) {
    const glm::dvec4 placed = map_from_world(view) * glm::dvec4(point, 1.0);
    if (placed.w <= 0.0) return false;
    const glm::dvec2 place = glm::dvec2(placed) / placed.w;
    return place.x >= 0.0 && place.x <= 1.0 && place.y >= 0.0 && place.y <= 1.0;
}

double side_at(const TextureView& view, const glm::dvec3& point) {
    if (const auto* parallel = std::get_if<ParallelView>(&view))
        return std::max(parallel->texel.x, parallel->texel.y) * parallel->size;
    const auto& pyramid = std::get<PyramidView>(view);
    const double ahead = (pyramid.light_from_world * (point - pyramid.position)).z;
    const glm::dvec2 side = pyramid.max - pyramid.min;
    return std::max(side.x, side.y) * std::max(ahead, 0.0);
}

} // namespace shadows
