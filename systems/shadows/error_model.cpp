#include "systems/shadows/error_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadows {

namespace {

double radius_of(const engine::WorldAabb& box) {
    return glm::length(box.extent()) * 0.5;
}

} // namespace

double magnification(const PairView& pair, const CasterGroup& casters) {
    if (pair.light.light.kind == scene::LightKind::directional) return 1.0;
    const double a = glm::length(casters.bounds.centre() - pair.light.position);
    const double reach = glm::length(pair.receiver.bounds.centre() - pair.light.position);
    const double nearest = std::max(a - radius_of(casters.bounds), 0.01 * a);
    return std::max(1.0, reach / std::max(nearest, 1e-6));
}

double screen_area_px(const scene::CameraView& camera, const engine::WorldAabb& box) {
    const double whole = static_cast<double>(camera.width) * camera.height;
    const double radius = radius_of(box);
    const double distance = glm::length(box.centre() - camera.position);
    if (distance <= radius) return whole;
    const double radius_px = radius / ((distance - radius) * camera.pixel_size());
    return std::min(whole, std::numbers::pi * radius_px * radius_px);
}

ShadowFootprint shadow_footprint(const PairView& pair, const CasterGroup& casters) {
    const double radius = radius_of(casters.bounds) * magnification(pair, casters);
    const glm::dvec3 nearest =
        glm::clamp(pair.scene.camera.position, pair.receiver.bounds.min, pair.receiver.bounds.max);
    const double distance = std::max(
        glm::length(nearest - pair.scene.camera.position),
        static_cast<double>(pair.scene.camera.near));
    const double radius_px = radius / (distance * pair.scene.camera.pixel_size());
    const double shown = screen_area_px(pair.scene.camera, pair.receiver.bounds);
    ShadowFootprint footprint;
    footprint.area_px = std::min(std::numbers::pi * radius_px * radius_px, shown);
    footprint.length_px = 2.0 * std::sqrt(std::numbers::pi * footprint.area_px);
    return footprint;
}

} // namespace shadows
