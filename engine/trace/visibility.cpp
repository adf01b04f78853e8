#include "engine/trace/visibility.hpp"

#include "engine/core/check.hpp"
#include "engine/core/random.hpp"
#include "engine/trace/light_cone.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace trace {
namespace {

/// The bits of an index in reverse, as a fraction.
/// Source: van der Corput, "Verteilungsfunktionen", 1935.
double radical_inverse(std::uint32_t index) {
    double value = 0.0;
    for (double digit = 0.5; index != 0; index >>= 1U, digit *= 0.5)
        if ((index & 1U) != 0) value += digit;
    return value;
}

double soft_visibility(
    const TraceScene& scene,
    const LightCone& cone,
    const Surface& surface,
    double offset,
    int samples,
    engine::Random random) {
    // Hammersley points, turned round the unit square by a random shift of their own for each
    // surface. Source: Cranley and Patterson, "Randomization of Number Theoretic Methods for
    // Multiple Integration", 1976.
    const glm::dvec2 shift = {random.uniform(), random.uniform()};
    const bool in_the_air = surface.normal == glm::dvec3(0.0);
    double arriving = 0.0;
    double possible = 0.0;
    for (int i = 0; i < samples; ++i) {
        const glm::dvec2 place = {
            (i + shift.x) / samples,
            std::fmod(radical_inverse(static_cast<std::uint32_t>(i)) + shift.y, 1.0)};
        const glm::dvec3 direction = cone.direction(place);
        const double weight = in_the_air ? 1.0 : glm::dot(surface.normal, direction);
        if (weight <= 0.0) continue;
        possible += weight;
        if (!scene.occluded(surface, direction, cone.distance(direction), offset))
            arriving += weight;
    }
    return possible > 0.0 ? arriving / possible : 0.0;
}

} // namespace

double visibility(
    const TraceScene& scene,
    const scene::PlacedLight& light,
    const Surface& surface,
    const VisibilityOptions& options,
    std::uint64_t stream) {
    CHECK_GT(options.samples, 0);
    if (!light.light.casts_shadow) return 1.0;
    const LightCone cone(light, surface.position);
    const double offset = options.offset.value_or(scene.default_offset());
    if (!cone.hard())
        return soft_visibility(
            scene, cone, surface, offset, options.samples, engine::Random(options.seed, stream));
    if (surface.normal != glm::dvec3(0.0) && glm::dot(surface.normal, cone.axis()) <= 0.0)
        return 0.0;
    return scene.occluded(surface, cone.axis(), cone.distance(cone.axis()), offset) ? 0.0 : 1.0;
}

float visibility(
    const TraceScene& scene,
    const scene::PlacedLight& light,
    const glm::dvec3& point,
    const glm::vec3& normal,
    int samples,
    std::uint64_t seed) {
    VisibilityOptions options;
    options.samples = samples;
    options.seed = seed;
    Surface surface;
    surface.position = point;
    surface.normal = normal;
    return static_cast<float>(visibility(scene, light, surface, options));
}

TracedPixel trace_pixel(
    const TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const glm::dvec2& place,
    const VisibilityOptions& options,
    std::uint64_t stream) {
    TracedPixel pixel;
    const glm::dvec3 direction = camera.ray_direction(place.x, place.y);
    const auto near = static_cast<double>(camera.near);
    pixel.hit = scene.intersect(camera.position + near * direction, direction);
    if (!pixel.hit) return pixel;
    pixel.hit->t += near;
    pixel.n_dot_l = glm::dot(pixel.hit->normal, LightCone(light, pixel.hit->position).axis());
    if (pixel.hit->receives)
        pixel.visibility = visibility(scene, light, *pixel.hit, options, stream);
    return pixel;
}

VisibilityImage::VisibilityImage(int width_px, int height_px) : width(width_px), height(height_px) {
    const std::size_t pixels = index(0, height_px);
    visibility.assign(pixels, 1.0F);
    entity.assign(pixels, ecs::kNoEntity.value);
    patch_id.assign(pixels, 0);
    depth.assign(pixels, std::numeric_limits<float>::infinity());
    normal.assign(pixels, glm::vec3(0.0F));
    n_dot_l.assign(pixels, 0.0F);
}

void VisibilityImage::set(std::size_t pixel, const TracedPixel& traced) {
    if (!traced.hit) return;
    visibility[pixel] = static_cast<float>(traced.visibility);
    entity[pixel] = traced.hit->entity.value;
    patch_id[pixel] = traced.hit->patch_id;
    depth[pixel] = static_cast<float>(traced.hit->t);
    normal[pixel] = glm::vec3(traced.hit->normal);
    n_dot_l[pixel] = static_cast<float>(traced.n_dot_l);
}

VisibilityImage trace_visibility(
    const TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const VisibilityOptions& options) {
    VisibilityImage image(camera.width, camera.height);
    for_each_row(camera.height, options.threads, options.progress, [&](int y) {
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            image.set(pixel, trace_pixel(scene, camera, light, {x + 0.5, y + 0.5}, options, pixel));
        }
    });
    return image;
}

void for_each_row(
    int height,
    int threads,
    const std::function<void(double)>& progress,
    const std::function<void(int)>& row) {
    std::atomic<int> next = 0;
    const auto work = [&](const std::function<void(double)>& report) {
        for (int y = next++; y < height; y = next++) {
            row(y);
            if (report) report((y + 1.0) / height);
        }
    };
    const int wanted =
        threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::thread> helpers;
    for (int i = 1; i < std::min(wanted, height); ++i)
        helpers.emplace_back(work, nullptr);
    work(progress);
    for (std::thread& helper : helpers)
        helper.join();
}

} // namespace trace
