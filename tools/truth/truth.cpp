#include "tools/truth/truth.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace truth {
namespace {

/// Visibilities that differ by more are different: any step of a hard edge, a steep part of a soft
/// one.
constexpr float kDiffers = 0.25F;
/// Neighbours of one entity whose depths differ by more, relatively, may be two surfaces.
constexpr float kDepthJump = 0.02F;
constexpr int kNearEdgePx = 2;
constexpr double kNudgePx = 0.05;
constexpr double kOffsetFactor = 4.0;
constexpr float kDepthTolerance = 1e-3F;

bool differs(float a, float b) {
    return std::abs(a - b) > kDiffers;
}

/// Whether the line between two neighbours is an edge of the shadow or of an entity.
bool shadow_or_entity_edge(const trace::VisibilityImage& image, std::size_t a, std::size_t b) {
    return image.entity[a] != image.entity[b] || differs(image.visibility[a], image.visibility[b]);
}

bool any_edge(const trace::VisibilityImage& image, std::size_t a, std::size_t b) {
    if (shadow_or_entity_edge(image, a, b) || image.patch_id[a] != image.patch_id[b]) return true;
    const float nearer = std::min(image.depth[a], image.depth[b]);
    return std::abs(image.depth[a] - image.depth[b]) > kDepthJump * nearer;
}

/// Marks both pixels of every edge, and all pixels within `radius` of them in x and in y.
template <class IsEdge>
std::vector<std::uint8_t>
near_edges(const trace::VisibilityImage& image, int radius, IsEdge is_edge) {
    std::vector<std::uint8_t> marks(image.pixel_count(), 0);
    const auto mark = [&](int x, int y) {
        for (int row = std::max(0, y - radius); row <= std::min(image.height - 1, y + radius);
             ++row)
            for (int column = std::max(0, x - radius);
                 column <= std::min(image.width - 1, x + radius);
                 ++column)
                marks[image.index(column, row)] = 1;
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t here = image.index(x, y);
            const bool right = x + 1 < image.width && is_edge(image, here, image.index(x + 1, y));
            const bool below = y + 1 < image.height && is_edge(image, here, image.index(x, y + 1));
            if (right || below) mark(x, y);
            if (right) mark(x + 1, y);
            if (below) mark(x, y + 1);
        }
    return marks;
}

/// Asks the questions again that should not matter.
class Doubter {
public:
    Doubter(
        const trace::TraceScene& scene,
        const scene::CameraView& camera,
        const scene::PlacedLight& light,
        const trace::VisibilityOptions& options)
        : scene_(scene),
          camera_(camera),
          light_(light),
          options_(options),
          higher_(options) {
        options_.progress = nullptr;
        higher_.progress = nullptr;
        higher_.offset = kOffsetFactor * options.offset.value_or(scene.default_offset());
    }

    [[nodiscard]] bool undecided(const trace::VisibilityImage& image, int x, int y) const {
        const std::size_t pixel = image.index(x, y);
        const glm::dvec2 centre = {x + 0.5, y + 0.5};
        if (other(image, pixel, centre, higher_)) return true;
        static constexpr std::array<glm::dvec2, 4> kNudges = {
            {{-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}}};
        return std::any_of(kNudges.begin(), kNudges.end(), [&](const glm::dvec2& nudge) {
            return other(image, pixel, centre + kNudgePx * nudge, options_);
        });
    }

private:
    /// Whether the same entity, sampled another way, has another visibility.
    [[nodiscard]] bool other(
        const trace::VisibilityImage& image,
        std::size_t pixel,
        const glm::dvec2& place,
        const trace::VisibilityOptions& options) const {
        const trace::TracedPixel again =
            trace::trace_pixel(scene_, camera_, light_, place, options, pixel);
        return again.hit && again.hit->entity.value == image.entity[pixel]
               && differs(static_cast<float>(again.visibility), image.visibility[pixel]);
    }

    const trace::TraceScene& scene_;
    const scene::CameraView& camera_;
    const scene::PlacedLight& light_;
    trace::VisibilityOptions options_;
    trace::VisibilityOptions higher_;
};

double part(std::size_t count, std::size_t of) {
    return of == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(of);
}

} // namespace

TruthImage true_visibility(
    const trace::TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const TruthOptions& options) {
    TruthImage truth;
    truth.image = trace::trace_visibility(scene, camera, light, options.visibility);
    const trace::VisibilityImage& image = truth.image;
    truth.undecided.assign(image.pixel_count(), 0);
    const std::vector<std::uint8_t> doubtful =
        options.all_pixels ? std::vector<std::uint8_t>(image.pixel_count(), 1)
                           : near_edges(image, kNearEdgePx, any_edge);
    const Doubter doubter(scene, camera, light, options.visibility);
    trace::for_each_row(image.height, options.visibility.threads, nullptr, [&](int y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            if (doubtful[pixel] == 0 || image.entity[pixel] == ecs::kNoEntity.value) continue;
            if (doubter.undecided(image, x, y)) truth.undecided[pixel] = 1;
        }
    });
    return truth;
}

trace::VisibilityImage second_grid(
    const trace::TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const trace::VisibilityOptions& options) {
    trace::VisibilityImage image(camera.width, camera.height);
    trace::for_each_row(camera.height, options.threads, options.progress, [&](int y) {
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t pixel = image.index(x, y);
            image.set(
                pixel,
                trace::trace_pixel(scene, camera, light, {x + 1.0, y + 1.0}, options, pixel));
        }
    });
    return image;
}

bool edge_near(
    const trace::TraceScene& scene,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    const glm::dvec2& middle,
    bool lit,
    double radius_px,
    double least_n_dot_l) {
    constexpr int kPlaces = 256;
    constexpr int kLightSamples = 16;
    trace::VisibilityOptions options;
    options.samples = kLightSamples;
    const auto differs = [&](double visibility) { return (visibility >= 0.5) != lit; };
    const auto plane = trace::trace_pixel(scene, camera, light, middle, options).hit;
    const auto differs_at = [&](const glm::dvec2& place) {
        const trace::TracedPixel there = trace::trace_pixel(scene, camera, light, place, options);
        if (there.hit && there.n_dot_l > least_n_dot_l && differs(there.visibility)) return true;
        const glm::dvec3 ray = camera.ray_direction(place.x, place.y);
        if (!plane || glm::dot(ray, plane->normal) >= 0.0) return false;
        trace::Surface beside = *plane;
        const double depth = glm::dot(plane->position - camera.position, plane->normal)
                             / glm::dot(ray, plane->normal);
        beside.position = camera.position + ray * depth;
        return differs(trace::visibility(scene, light, beside, options));
    };
    // A pixel's surroundings finely, then the whole disc. Places on a spiral of the golden angle
    // cover a disc evenly. Source: Vogel, "A Better Way to Construct the Sunflower Head", 1979.
    for (const double radius : {std::min(radius_px, 1.0), radius_px})
        for (int i = 0; i < kPlaces; ++i) {
            const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            if (differs_at(middle + way * (radius * std::sqrt((i + 0.5) / kPlaces)))) return true;
        }
    return false;
}

std::vector<glm::dvec3>
surface_points(const scene::CameraView& camera, const trace::VisibilityImage& image) {
    std::vector<glm::dvec3> points;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto depth = static_cast<double>(image.depth[image.index(x, y)]);
            if (std::isfinite(depth))
                points.push_back(camera.position + camera.ray_direction(x + 0.5, y + 0.5) * depth);
        }
    return points;
}

Shares shares(const TruthImage& truth) {
    const trace::VisibilityImage& image = truth.image;
    const std::vector<std::uint8_t> edges = near_edges(image, 1, shadow_or_entity_edge);
    std::size_t surface = 0;
    std::size_t facing = 0;
    std::size_t shadow = 0;
    std::size_t undecided = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        if (image.entity[i] == ecs::kNoEntity.value) continue;
        ++surface;
        const bool faces = image.n_dot_l[i] > 0.0F;
        if (faces) ++facing;
        if (faces && image.visibility[i] < 0.5F) ++shadow;
        if (truth.undecided[i] == 0) continue;
        ++undecided;
        if (edges[i] == 0) ++inside;
    }
    return {
        part(surface, image.pixel_count()),
        part(shadow, facing),
        part(surface - facing, surface),
        part(undecided, surface),
        part(inside, surface)};
}

std::vector<std::uint8_t> validity(
    const TruthImage& truth,
    std::span<const std::uint32_t> entity_ids,
    std::span<const float> depth) {
    const trace::VisibilityImage& image = truth.image;
    CHECK_EQ(entity_ids.size(), image.pixel_count());
    CHECK_EQ(depth.size(), image.pixel_count());
    std::vector<std::uint8_t> valid(image.pixel_count(), 0);
    for (std::size_t i = 0; i < valid.size(); ++i) {
        const bool same = image.entity[i] != ecs::kNoEntity.value
                          && image.entity[i] == entity_ids[i]
                          && std::abs(depth[i] - image.depth[i]) < kDepthTolerance * image.depth[i];
        valid[i] = same ? 1 : 0;
    }
    return valid;
}

} // namespace truth
