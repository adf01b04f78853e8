#include "systems/shadows/screen_bounds.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shadows {

namespace {

/// The smallest rectangle of the window round some points of view space.
class WindowRectangle {
public:
    explicit WindowRectangle(const scene::CameraView& camera)
        : size_(camera.width, camera.height),
          px_per_slope_(1.0 / camera.pixel_size()) {}

    /// @pre point_vs.z < 0
    void grow(const glm::dvec3& point_vs) {
        const glm::dvec2 window =
            size_ * 0.5 + glm::dvec2(point_vs) * (px_per_slope_ / -point_vs.z);
        min_ = glm::min(min_, window);
        max_ = glm::max(max_, window);
    }

    [[nodiscard]] PixelBox pixels() const {
        const glm::dvec2 low = glm::clamp(min_, glm::dvec2(0.0), size_);
        const glm::dvec2 high = glm::clamp(max_, glm::dvec2(0.0), size_);
        return {
            static_cast<int>(std::floor(low.x)),
            static_cast<int>(std::floor(low.y)),
            static_cast<int>(std::ceil(high.x)),
            static_cast<int>(std::ceil(high.y))};
    }

private:
    glm::dvec2 size_;
    double px_per_slope_; ///< pixels per unit of (metres across over metres ahead)
    glm::dvec2 min_ = glm::dvec2(std::numeric_limits<double>::infinity());
    glm::dvec2 max_ = -min_;
};

} // namespace

PixelBox screen_bounds(const scene::CameraView& camera, const engine::WorldAabb& box) {
    if (box.empty()) return {};
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[static_cast<std::size_t>(i)] = box.corner(i);
    return hull_bounds(camera, corners);
}

PixelBox hull_bounds(const scene::CameraView& camera, std::span<const glm::dvec3> points) {
    const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(camera.world_from_view));
    std::array<glm::dvec3, kMostHullPoints> room;
    CHECK_LE(points.size(), room.size());
    const std::span<glm::dvec3> points_vs(room.data(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        points_vs[i] = view_from_world * (points[i] - camera.position);
    const double nearest = -static_cast<double>(camera.near);
    WindowRectangle rectangle(camera);
    bool seen = false;
    for (const glm::dvec3& before : points_vs) {
        if (before.z > nearest) continue;
        rectangle.grow(before);
        seen = true;
        for (const glm::dvec3& behind : points_vs) {
            if (behind.z <= nearest) continue;
            const double t = (nearest - before.z) / (behind.z - before.z);
            rectangle.grow(glm::mix(before, behind, t));
        }
    }
    return seen ? rectangle.pixels() : PixelBox{};
}

double pixel_size_at(const scene::CameraView& camera, const engine::WorldAabb& box) {
    const glm::dvec3 nearest = glm::clamp(camera.position, box.min, box.max);
    const double distance =
        std::max(glm::length(nearest - camera.position), static_cast<double>(camera.near));
    return distance * camera.pixel_size();
}

double typical_distance(const scene::CameraView& camera, const engine::WorldAabb& box) {
    constexpr double kAtFeet = 0.02; // of the box's size
    const glm::dvec3 nearest = glm::clamp(camera.position, box.min, box.max);
    const double least =
        std::max(static_cast<double>(camera.near), kAtFeet * glm::length(box.extent()));
    const double near = std::max(glm::length(nearest - camera.position), least);
    const double centre = std::max(glm::length(box.centre() - camera.position), near);
    return std::sqrt(near * centre);
}

} // namespace shadows
