#include "systems/shadows/volumes/start_count.hpp"

#include "systems/shadows/volumes/near_clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadows {

namespace {

/// A triple product of three ways: above 0 on one side of the plane of two of them.
double triple(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(glm::cross(a, b), c);
}

/// All points between the near rectangle and the light, in mesh space.
class NearClipVolume {
public:
    NearClipVolume(const std::array<glm::dvec3, 4>& corners, const glm::dvec4& light) {
        const glm::dvec3 middle = (corners[0] + corners[2]) * 0.5;
        const auto to_light = [&](const glm::dvec3& from) {
            return glm::dvec3(light) - from * light.w;
        };
        const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[3] - corners[0]);
        add(across, corners[0], glm::dot(across, to_light(middle)));
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec3& a = corners[i];
            const glm::dvec3 normal = glm::cross(corners[(i + 1) % 4] - a, to_light(a));
            add(normal, a, glm::dot(normal, middle - a));
        }
    }

    /// Nothing lies between: the light is in the rectangle's own plane.
    [[nodiscard]] bool is_flat() const { return flat_; }

    /// Whether a segment enters it, or comes nearer than rounding lets one tell.
    /// Source: M. Cyrus and J. Beck, "Generalized Two- and Three-Dimensional Clipping", 1978.
    [[nodiscard]] bool meets(const glm::dvec3& from, const glm::dvec3& to) const {
        double first = 0.0;
        double last = 1.0;
        for (const Plane& plane : planes_) {
            const double a = glm::dot(plane.normal, from - plane.point);
            const double b = glm::dot(plane.normal, to - plane.point);
            const double rounding =
                1e-9 * (glm::length(from - plane.point) + glm::length(to - plane.point));
            if (a < -rounding && b < -rounding) return false;
            if (a < -rounding) first = std::max(first, (-rounding - a) / (b - a));
            if (b < -rounding) last = std::min(last, (-rounding - a) / (b - a));
        }
        return first <= last;
    }

private:
    struct Plane {
        glm::dvec3 normal; ///< unit, inward
        glm::dvec3 point;
    };

    /// @param inside its sign says on which side of the plane the volume is
    void add(const glm::dvec3& normal, const glm::dvec3& point, double inside) {
        const double length = glm::length(normal);
        flat_ = flat_ || inside == 0.0 || length == 0.0;
        planes_[count_++] = {normal / (inside < 0.0 ? -length : length), point};
    }

    std::array<Plane, 5> planes_{};
    std::size_t count_ = 0;
    bool flat_ = false;
};

/// A side's first triangle runs along an edge of the outline: two corners of it are vertices.
bool outline_meets(
    const ShadowVolume& volume,
    std::span<const glm::vec3> positions,
    const NearClipVolume& between) {
    for (std::size_t i = volume.far_end; i < volume.side_end; i += 3) {
        std::array<glm::dvec3, 3> ends{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k)
            if (volume.indices[i + k] % 2 == 0)
                ends[count++] = positions[volume.indices[i + k] / 2];
        if (count == 2 && between.meets(ends[0], ends[1])) return true;
    }
    return false;
}

/// Caps between a place and the light.
int caps_before(
    const ShadowVolume& volume,
    std::span<const glm::vec3> positions,
    const glm::dvec3& place,
    const glm::dvec4& light) {
    const glm::dvec3 way = glm::dvec3(light) - place * light.w;
    int count = 0;
    for (std::size_t i = volume.side_end; i < volume.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(positions[volume.indices[i + k] / 2]) - place;
        };
        const glm::dvec3 a = corner(0);
        const glm::dvec3 b = corner(1);
        const double ab = triple(a, b, way);
        const glm::dvec3 c = corner(2);
        const double bc = triple(b, c, way);
        if (ab * bc <= 0.0) continue;
        const double ca = triple(c, a, way);
        if (ab * ca <= 0.0) continue;
        // Where the line meets the plane, in lengths of the way. Source: Cramer's rule.
        const double along = triple(a, b, c) / (ab + bc + ca);
        if (along > 0.0 && (light.w == 0.0 || along < 1.0)) ++count;
    }
    return count;
}

} // namespace

std::optional<int> start_count(
    const scene::CameraView& camera,
    const ShadowVolume& volume,
    std::span<const glm::vec3> positions,
    const glm::dmat4& world_from_mesh,
    const glm::dvec4& light_mesh,
    const engine::WorldAabb& bounds) {
    const glm::dmat4 mesh_from_world = glm::inverse(world_from_mesh);
    std::array<glm::dvec3, 4> corners = near_rectangle(camera);
    engine::WorldAabb rectangle;
    for (glm::dvec3& corner : corners) {
        corner += camera.position;
        rectangle.grow(corner);
        corner = glm::dvec3(mesh_from_world * glm::dvec4(corner, 1.0));
    }
    rectangle.grow(camera.position);
    if (rectangle.intersects(bounds)) return std::nullopt;
    const NearClipVolume between(corners, light_mesh);
    if (between.is_flat() || outline_meets(volume, positions, between)) return std::nullopt;
    // Any place of the rectangle will do; this one is on no symmetry, where edges like to lie.
    const glm::dvec3 place =
        corners[0] + (corners[1] - corners[0]) * 0.4871 + (corners[3] - corners[0]) * 0.5237;
    return caps_before(volume, positions, place, light_mesh);
}

} // namespace shadows
