#include "systems/shadows/techniques/local_map_job.hpp"

#include "systems/shadows/maps/map_resolution.hpp"
#include "systems/shadows/techniques/map_uniforms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadows {

double pyramid_texel_of_one(const PairView& pair, double tan_half) {
    const engine::WorldAabb& bounds = pair.receiver.bounds;
    const glm::dvec3& light = pair.light.position;
    // Texels grow away from the light, pixels away from the camera: the point that counts is the
    // one nearest to the camera.
    const glm::dvec3 shown = glm::clamp(pair.scene.camera.position, bounds.min, bounds.max);
    const double range = static_cast<double>(pair.light.light.range);
    return 2.0 * tan_half * std::min(glm::length(shown - light), range);
}

double LocalMapJob::nearest_blocker() const {
    const auto radius = static_cast<double>(light().light.radius);
    double nearest = std::numeric_limits<double>::infinity();
    for (const engine::WorldAabb& box : caster_bounds())
        nearest = std::min(
            nearest,
            glm::length(light().position - glm::clamp(light().position, box.min, box.max)));
    // What is nearer has penumbrae as wide as a face.
    constexpr double kLeastRadii = 4.0;
    return std::max(nearest / std::sqrt(3.0), kLeastRadii * radius);
}

void LocalMapJob::fit(const ShadowRequest& /*request*/, int size) {
    const int border = remedies().on(Remedy::map_padded_faces) ? filter_border(filter()) + 1 : 0;
    const bool soft = filter() == MapFilter::pcss;
    // In a corner of a face the light is seen as an ellipse, longer by the root of three.
    const double reach =
        soft ? std::sqrt(3.0) * static_cast<double>(light().light.radius) / nearest_blocker() : 0.0;
    views_.clear();
    if (kind_ == Kind::spot) {
        views_.push_back(spot_view(light(), caster_bounds(), size, border, reach));
    } else {
        const auto faces = cube_views(light().position, size, border, reach);
        views_.assign(faces.begin(), faces.end());
    }
    constexpr double kUsualNear = 0.1; // metres
    if (!remedies().on(Remedy::map_near_casters))
        for (PyramidView& view : views_)
            view.near = kUsualNear;
}

double LocalMapJob::texel_m_of_one(const PairView& pair) const {
    const bool spot = kind_ == Kind::spot;
    return pyramid_texel_of_one(
        pair, spot ? std::tan(static_cast<double>(pair.light.light.outer_angle)) : 1.0);
}

Resolution
LocalMapJob::resolution(const scene::CameraView& camera, const SurfacePoint& point) const {
    const auto ahead = [&](const PyramidView& view) {
        return (view.light_from_world * (point.position - view.position)).z;
    };
    const auto looked_into = std::max_element(
        views_.begin(), views_.end(), [&](const PyramidView& a, const PyramidView& b) {
            return ahead(a) < ahead(b);
        });
    if (ahead(*looked_into) <= 0.0) return {};
    return on_screen(camera, point, texel_at(*looked_into, point, filter_reach(filter())));
}

void LocalMapJob::place(const gpu::Program& mask, const scene::CameraView& camera) const {
    set_view(mask, views_.front(), camera);
    if (kind_ == Kind::cube) mask.set("light_from_world", glm::mat3(cube_turn())); // for all faces
    const double near = views_.front().near;
    mask.set(
        "light_source",
        glm::vec2(glm::dvec2(
            static_cast<double>(light().light.radius) / near, near / nearest_blocker())));
}

} // namespace shadows
