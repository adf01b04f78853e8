#include "systems/shadows/blob_fit.hpp"

#include "systems/shadows/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace shadows {

namespace {

/// The thinnest a blob gets, relative to its longest side, and in metres.
constexpr double kThinnest = 1e-3;
constexpr double kThinnestMetres = 1e-6;

/// The part of a ray from the origin along `direction`, in multiples of it, that lies in a box.
struct RayPart {
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
};

/// Source: Kay and Kajiya's slabs, 1986.
RayPart part_inside(const engine::WorldAabb& box, const glm::dvec3& direction) {
    RayPart part;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (box.min[axis] > 0.0 || box.max[axis] < 0.0) return {1.0, 0.0};
            continue;
        }
        const double a = box.min[axis] / direction[axis];
        const double b = box.max[axis] / direction[axis];
        part.enter = std::max(part.enter, std::min(a, b));
        part.leave = std::min(part.leave, std::max(a, b));
    }
    return part;
}

/// A unit vector at right angles to two; they may be parallel, or have no length.
glm::dvec3 across(const glm::dvec3& a, const glm::dvec3& b) {
    if (const glm::dvec3 normal = glm::cross(a, b); glm::length(normal) > 0.0)
        return glm::normalize(normal);
    const glm::dvec3 along = glm::length(a) > glm::length(b) ? a : b;
    for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
        if (const glm::dvec3 normal = glm::cross(along, axis); glm::length(normal) > 0.0)
            return glm::normalize(normal);
    return {0.0, 0.0, 1.0};
}

engine::WorldAabb grown(const engine::WorldAabb& box, double margin) {
    return {box.min - margin, box.max + margin};
}

engine::WorldAabb scaled(const engine::WorldAabb& box, const glm::dvec3& from, double factor) {
    return {from + (box.min - from) * factor, from + (box.max - from) * factor};
}

double radius_of(const engine::WorldAabb& box) {
    return glm::length(box.extent()) * 0.5;
}

engine::WorldAabb cut(const engine::WorldAabb& swept, const engine::WorldAabb& receiver) {
    const engine::WorldAabb shared{
        glm::max(swept.min, receiver.min), glm::min(swept.max, receiver.max)};
    return shared.empty() ? engine::WorldAabb{} : shared;
}

engine::WorldAabb swept_by_sun(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver) {
    const glm::dvec3 direction(light.direction);
    const engine::WorldAabb soft = grown(caster, kBlobEdge * radius_of(caster));
    const RayPart way = part_inside({receiver.min - soft.max, receiver.max - soft.min}, direction);
    if (way.enter > way.leave) return {};
    engine::WorldAabb swept{soft.min + direction * way.enter, soft.max + direction * way.enter};
    swept.grow({soft.min + direction * way.leave, soft.max + direction * way.leave});
    const double spread = std::tan(static_cast<double>(light.light.angular_radius)) * way.leave;
    return cut(grown(swept, spread), receiver);
}

engine::WorldAabb swept_by_lamp(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver) {
    const double radius = radius_of(caster);
    const double near = glm::length(caster.centre() - light.position) - radius;
    if (near <= 0.0) return receiver;
    const glm::dvec3 farthest =
        glm::max(glm::abs(receiver.min - light.position), glm::abs(receiver.max - light.position));
    const double factor = std::max(1.0, glm::length(farthest) / near);
    const engine::WorldAabb soft = grown(caster, kBlobEdge * radius);
    engine::WorldAabb swept = soft;
    swept.grow(scaled(soft, light.position, factor));
    return cut(grown(swept, static_cast<double>(light.light.radius) * (factor - 1.0)), receiver);
}

} // namespace

Blob fit_blob(const CasterView& caster) {
    const glm::dvec3 half(caster.bounds_mesh.extent() * 0.5F);
    const glm::dmat3 axes(caster.world_from_mesh);
    glm::dmat3 world_from_unit(axes[0] * half.x, axes[1] * half.y, axes[2] * half.z);
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        longest = std::max(longest, glm::length(world_from_unit[axis]));
    const double thinnest = std::max(longest * kThinnest, kThinnestMetres);
    for (int axis = 0; axis < 3; ++axis)
        if (glm::length(world_from_unit[axis]) < thinnest)
            world_from_unit[axis] =
                thinnest * across(world_from_unit[(axis + 1) % 3], world_from_unit[(axis + 2) % 3]);
    Blob blob;
    blob.centre = glm::dvec3(
        caster.world_from_mesh * glm::dvec4(glm::dvec3(caster.bounds_mesh.centre()), 1.0));
    blob.unit_from_world = glm::inverse(world_from_unit);
    return blob;
}

Blob round_blob(const Blob& blob, const LightView& light) {
    return {blob.centre, glm::dmat3(1.0 / disc_radius(blob, light))};
}

double disc_radius(const Blob& blob, const LightView& light) {
    const glm::dvec3 direction = light_direction(light, blob.centre);
    return std::sqrt(
        glm::length(blob.unit_from_world * direction)
        / std::abs(glm::determinant(blob.unit_from_world)));
}

glm::dvec3 light_direction(const LightView& light, const glm::dvec3& point) {
    if (light.light.kind == scene::LightKind::directional) return glm::dvec3(light.direction);
    const glm::dvec3 way = point - light.position;
    return glm::length(way) > 0.0 ? glm::normalize(way) : glm::dvec3(light.direction);
}

engine::WorldAabb swept_bounds(
    const LightView& light, const engine::WorldAabb& caster, const engine::WorldAabb& receiver) {
    if (caster.empty() || receiver.empty()) return {};
    return light.light.kind == scene::LightKind::directional
               ? swept_by_sun(light, caster, receiver)
               : swept_by_lamp(light, caster, receiver);
}

} // namespace shadows
