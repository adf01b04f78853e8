#include "systems/shadows/maps/cascade_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadows {

namespace {

/// Sizes change in steps of an eighth of an octave, so that they stay while bounds move a little.
double stepped_up(double length) {
    return std::exp2(std::ceil(std::log2(length) * 8.0) / 8.0);
}

/// Rows of a view along `direction` with `right` as near to the one wanted as can be.
glm::dmat3 axes_from(const glm::dvec3& direction, const glm::dvec3& right) {
    const glm::dvec3 level = glm::normalize(right - direction * glm::dot(right, direction));
    return axes_from_rows(level, glm::cross(level, direction), direction);
}

/// A rectangle across the light.
struct Rectangle {
    glm::dvec2 min = glm::dvec2(std::numeric_limits<double>::infinity());
    glm::dvec2 max = -min;

    void grow(const glm::dvec2& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void widen(double by) {
        min -= by;
        max += by;
    }
    [[nodiscard]] glm::dvec2 extent() const { return max - min; }
    [[nodiscard]] glm::dvec2 centre() const { return (min + max) * 0.5; }
};

Rectangle rectangle_of(const glm::dmat3& light_from_world, const engine::WorldAabb& box) {
    Rectangle rectangle;
    for (int i = 0; i < 8; ++i)
        rectangle.grow(glm::dvec2(light_from_world * box.corner(i)));
    return rectangle;
}

DepthRange along_light(const glm::dmat3& light_from_world, const engine::WorldAabb& box) {
    DepthRange range{
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 8; ++i) {
        const double depth = (light_from_world * box.corner(i)).z;
        range.near = std::min(range.near, depth);
        range.far = std::max(range.far, depth);
    }
    return range;
}

/// Squared tangent of the angle between the view axis and the picture's corners.
double corner_tangent_2(const scene::CameraView& camera) {
    const double up = std::tan(static_cast<double>(camera.fov_y) * 0.5);
    const double right = up * camera.aspect();
    return up * up + right * right;
}

/// The smallest sphere round a slice of the view: its centre's view depth and its radius.
struct SliceSphere {
    double depth;
    double radius;
};

SliceSphere sphere_round(const scene::CameraView& camera, double near, double far) {
    const double k_2 = corner_tangent_2(camera);
    const double depth = std::min(far, 0.5 * (near + far) * (1.0 + k_2));
    return {depth, std::sqrt((far - depth) * (far - depth) + far * far * k_2)};
}

/// Bounds of the slice itself: tight, and different in every frame.
Rectangle tight_rectangle(const CascadeRequest& request, double near, double far) {
    const scene::CameraView& camera = request.camera;
    Rectangle rectangle;
    for (const double depth : {near, far})
        for (const double x : {0.0, static_cast<double>(camera.width)})
            for (const double y : {0.0, static_cast<double>(camera.height)})
                rectangle.grow(glm::dvec2(
                    request.light_from_world
                    * (camera.position + camera.ray_direction(x, y) * depth)));
    return rectangle;
}

/// What receivers inside a sphere can cover across the light: never more than the sphere, and less
/// up and down where the receivers are flat and the sun is low. Its size depends on the radius, the
/// light and the receivers' height alone.
Rectangle sphere_rectangle(const CascadeRequest& request, double near, double far) {
    const SliceSphere sphere = sphere_round(request.camera, near, far);
    const glm::dvec3 forward = -glm::dvec3(request.camera.world_from_view[2]);
    const glm::dvec3 middle = request.camera.position + forward * sphere.depth;
    const engine::WorldAabb& receivers = request.receivers;
    const glm::dvec3 level(middle.x, receivers.centre().y, middle.z);
    const double half_height = receivers.extent().y * 0.5;
    const glm::dmat3 world_from_light = glm::transpose(request.light_from_world);
    Rectangle rectangle;
    for (int axis = 0; axis < 2; ++axis) {
        const glm::dvec3 across = world_from_light[axis];
        const double flat =
            sphere.radius * std::hypot(across.x, across.z) + half_height * std::abs(across.y);
        const bool is_flat = flat < sphere.radius;
        const double half = stepped_up(is_flat ? flat : sphere.radius);
        const double centre = glm::dot(across, is_flat ? level : middle);
        rectangle.min[axis] = centre - half;
        rectangle.max[axis] = centre + half;
    }
    return rectangle;
}

/// Texels lie on a grid that is fixed to the world.
void snap(ParallelView& view) {
    view.min = glm::floor(view.min / view.texel) * view.texel;
}

/// To 24 bits. A cast to float and back is taken out again by GCC 12 when it vectorises.
double as_float(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, 24)), exponent - 24);
}

/// What the same arithmetic gives in floats, far from the origin.
void round_to_floats(ParallelView& view) {
    view.min = {as_float(view.min.x), as_float(view.min.y)};
    view.nearest = as_float(view.nearest);
    view.farthest = as_float(view.farthest);
}

/// Along the light, where something receives. Casters before that are pressed onto its near end, as
/// long as nobody asks how far away they are: penumbrae do.
DepthRange needed_depths(const CascadeRequest& request, const Remedies& remedies) {
    DepthRange depth = along_light(request.light_from_world, request.receivers);
    if (request.soft > 0.0 && remedies.on(Remedy::soft_true_heights))
        for (const engine::WorldAabb& caster : request.casters)
            depth.near = std::min(depth.near, along_light(request.light_from_world, caster).near);
    const double slack = std::max(depth.far - depth.near, 1e-3) * 1e-3;
    return {depth.near - slack, depth.far + slack};
}

/// Across the light, where something casts and something receives.
Rectangle needed_rectangle(const CascadeRequest& request, const DepthRange& depth) {
    Rectangle receivers = rectangle_of(request.light_from_world, request.receivers);
    receivers.widen(request.soft * (depth.far - depth.near));
    Rectangle casters;
    for (const engine::WorldAabb& caster : request.casters) {
        const Rectangle one = rectangle_of(request.light_from_world, caster);
        casters.grow(one.min);
        casters.grow(one.max);
    }
    Rectangle both{glm::max(receivers.min, casters.min), glm::min(receivers.max, casters.max)};
    const bool meet = glm::all(glm::lessThan(both.min, both.max));
    return meet ? both : receivers;
}

ParallelView
view_over(const CascadeRequest& request, const Rectangle& rectangle, const DepthRange& depth) {
    ParallelView view;
    view.light_from_world = request.light_from_world;
    view.size = request.size;
    // Snapping moves the corner by up to a texel.
    view.texel = rectangle.extent() / static_cast<double>(request.size - 1);
    view.min = rectangle.min;
    view.nearest = depth.near;
    view.farthest = depth.far;
    return view;
}

} // namespace

DepthRange wanted_range(const ShadowScene& scene) {
    // No farther ratio than the cascades can spread evenly: what is nearer shares the first.
    constexpr double kMostRatio = 256.0;
    const double far = std::max(scene.farthest_m, 2.0 * static_cast<double>(scene.camera.near));
    return {std::clamp(scene.nearest_m, far / kMostRatio, far * 0.5), far};
}

DepthRange steady_range(const DepthRange& wanted, const std::optional<DepthRange>& before) {
    constexpr double kStep = 1.4142135623730951; // a range moves in half octaves ...
    constexpr double kWaste = 2.0;               // ... and stays until it is an octave too large
    const auto fits = [&](const DepthRange& range) {
        return range.near <= wanted.near && range.far >= wanted.far
               && range.near * kWaste * kStep >= wanted.near && range.far <= wanted.far * kWaste;
    };
    if (before && fits(*before)) return *before;
    return {
        std::exp2(std::floor(std::log2(wanted.near) * 2.0) / 2.0),
        std::exp2(std::ceil(std::log2(wanted.far) * 2.0) / 2.0)};
}

HeldRange held_range(
    const DepthRange& wanted, const std::optional<HeldRange>& before, const Remedies& remedies) {
    if (!before) return {steady_range(wanted, std::nullopt)};
    const DepthRange& last = before->range;
    const DepthRange steady = steady_range(wanted, last);
    if (steady == last || !remedies.on(Remedy::map_held_range)) return {steady};
    const bool less_does = last.near <= wanted.near && last.far >= wanted.far;
    if (!less_does) return {{std::min(steady.near, last.near), std::max(steady.far, last.far)}};
    if (before->frames_too_large + 1 >= kHeldFrames) return {steady};
    return {last, before->frames_too_large + 1};
}

int cascade_count(const DepthRange& range) {
    const double octaves = std::log(range.far / range.near) / std::log(2.7);
    return std::clamp(static_cast<int>(std::ceil(octaves)), 1, kMaxCascades);
}

std::vector<double> split_depths(const DepthRange& range, int count) {
    std::vector<double> depths;
    for (int i = 1; i <= count; ++i)
        depths.push_back(
            range.near * std::pow(range.far / range.near, static_cast<double>(i) / count));
    return depths;
}

double slice_end(const DepthRange& range, int count, double depth) {
    const double octaves = std::log2(range.far / range.near);
    const double passed = count * std::log2(depth / range.near) / octaves;
    const double index = std::clamp(std::ceil(passed), 1.0, static_cast<double>(count));
    return range.near * std::exp2(octaves * index / count);
}

glm::dmat3 light_axes(
    const glm::dvec3& direction,
    const std::optional<glm::dmat3>& before,
    const Remedies& remedies) {
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::cross(direction, up);
    // Between six and nine degrees off the vertical the axes before decide.
    const double off_vertical = glm::length(right);
    const double needed = before ? 0.15 : 0.1;
    if (!remedies.on(Remedy::map_steady_up)) {
        const bool vertical = off_vertical < 0.01;
        return axes_from(
            direction, vertical ? glm::cross(direction, glm::dvec3(0.0, 0.0, 1.0)) : right);
    }
    if (off_vertical >= needed)
        return axes_from(direction, right + 0.25 * glm::cross(right, direction));
    const glm::dvec3 held =
        before ? glm::dvec3(glm::transpose(*before)[0]) : glm::dvec3(1.0, 0.0, 0.0);
    return axes_from(direction, held);
}

std::vector<ParallelView> fit_cascades(const CascadeRequest& request, const Remedies& remedies) {
    std::vector<ParallelView> views;
    const DepthRange depth = needed_depths(request, remedies);
    const Rectangle all = needed_rectangle(request, depth);
    double near = static_cast<double>(request.camera.near);
    for (const double far : split_depths(request.range, request.count)) {
        Rectangle rectangle = remedies.on(Remedy::map_constant_size)
                                  ? sphere_rectangle(request, near, far)
                                  : tight_rectangle(request, near, far);
        rectangle.widen(request.soft * (depth.far - depth.near));
        int whole_axes = 0;
        for (int axis = 0; axis < 2; ++axis) {
            const double whole = stepped_up(std::max(all.extent()[axis], 1e-3));
            if (whole > rectangle.extent()[axis]) continue;
            rectangle.min[axis] = all.centre()[axis] - whole * 0.5;
            rectangle.max[axis] = all.centre()[axis] + whole * 0.5;
            ++whole_axes;
        }
        ParallelView view = view_over(request, rectangle, depth);
        if (remedies.on(Remedy::map_snapped_texels)) snap(view);
        if (!remedies.on(Remedy::map_near_origin)) round_to_floats(view);
        views.push_back(view);
        if (whole_axes == 2) break;
        near = far;
    }
    return views;
}

bool reaches(const ParallelView& view, const engine::WorldAabb& caster) {
    const Rectangle rectangle = rectangle_of(view.light_from_world, caster);
    const glm::dvec2 max = view.min + view.texel * static_cast<double>(view.size);
    return along_light(view.light_from_world, caster).near <= view.farthest
           && glm::all(glm::lessThanEqual(rectangle.min, max))
           && glm::all(glm::lessThanEqual(view.min, rectangle.max));
}

} // namespace shadows
