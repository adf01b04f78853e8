// Failures of blobs. A blob is never exact: what is promised is that it lies where the shadow lies
// and covers most of it. That a blob under a roof darkens what the roof darkened already is no
// case: masks take the minimum.

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::floor_of;
using test_support::sun_along;
using test_support::sun_at;
using test_support::WorldBuilder;

Stage stage_of(WorldBuilder& builder, const scene::CameraView& camera) {
    return pinned_stage(std::move(builder.world), camera, "sun", "floor", "blob");
}

scene::CameraView camera_at(const glm::dvec3& eye, const glm::dvec3& target) {
    return test_support::camera_looking(eye, target, kPictureSize, kPictureSize);
}

/// A plank of 2 square metres, more or less elongated.
Stage plank(double length) {
    WorldBuilder builder = floor_of(20.0F);
    const auto along = static_cast<float>(length);
    builder.add("plank", scene::make_box({along, 0.1F, 2.0F / along}), at({0.0, 1.0, 0.0}));
    builder.add_light(sun_along({0.0, -1.0, 0.0}));
    return stage_of(builder, camera_at({0.0, 2.5, 3.5}, {0.0, 0.0, 0.0}));
}

Stage low_sun(double elevation) {
    WorldBuilder builder = floor_of(60.0F);
    builder.add("ball", scene::make_sphere(0.5F), at({0.0, 2.0, 0.0}));
    builder.add_light(sun_at(elevation));
    const double x = 2.0 / std::tan(glm::radians(elevation));
    return stage_of(
        builder, camera_at({0.5 * x, 4.0 + 0.4 * x, 5.0 + 0.4 * x}, {0.5 * x, 0.5, 0.0}));
}

Stage ledge(double x) {
    WorldBuilder builder;
    builder.add("floor/upper", scene::make_plane({10.0F, 20.0F}), at({-5.0, 0.0, 0.0}));
    builder.add("floor/lower", scene::make_plane({10.0F, 20.0F}), at({5.0, -3.0, 0.0}));
    builder.add("ball", scene::make_sphere(0.5F), at({x, 1.0, 0.0}));
    builder.add_light(sun_along({0.0, -1.0, 0.0}));
    return stage_of(builder, camera_at({2.0, 4.0, 4.0}, {0.0, -1.0, 0.0}));
}

/// Counts of wrong and right shadow pixels.
struct Overlap {
    double both = 0.0;
    double either = 0.0;
};

Overlap overlap(const measure::Comparison& comparison) {
    Overlap count;
    for (std::size_t i = 0; i < comparison.kind.size(); ++i) {
        if (comparison.kind[i] != measure::PixelKind::valid) continue;
        const bool drawn = !measure::lit(comparison.measured.visibility[i]);
        const bool truly = !measure::lit(comparison.truth.visibility[i]);
        count.both += drawn && truly ? 1.0 : 0.0;
        count.either += drawn || truly ? 1.0 : 0.0;
    }
    return count;
}

/// 1 - intersection over union of the drawn and the true shadow.
Gate missed_overlap(double at_most) {
    return {
        "1 - intersection over union",
        [](const Observation& seen) {
            const Overlap count = overlap(seen.comparison);
            return count.either > 0.0 ? 1.0 - count.both / count.either : 0.0;
        },
        at_most};
}

/// The sum of |V - V*| over the true shadow's area.
Gate error_over_area(double at_most) {
    return {
        "error over the shadow's area",
        [](const Observation& seen) {
            double area = 0.0;
            for (std::size_t i = 0; i < seen.comparison.kind.size(); ++i)
                if (seen.comparison.kind[i] == measure::PixelKind::valid)
                    area += 1.0 - static_cast<double>(seen.comparison.truth.visibility[i]);
            return seen.figures.error_px / area;
        },
        at_most};
}

} // namespace

std::vector<Case> blob_cases() {
    return {
        // An ellipse in a rectangle leaves 1 - pi / 4 of it; the soft edge adds a little.
        {"B1",
         "a plank throws a round stain",
         plank,
         {1.5, 4.0, 4.0},
         Remedy::blob_aspect,
         {error_over_area(0.35), missed_overlap(0.25)}},
        {"B2",
         "a stain lies straight below the ball although the sun is low",
         low_sun,
         {90.0, 5.0, 15.0},
         Remedy::blob_along_light,
         {error_over_area(0.2), missed_overlap(0.1)}},
        {"B3",
         "half the blob floats over a pit, and the pit stays bright",
         ledge,
         {-1.0, 1.0, 0.0},
         Remedy::blob_on_surface,
         {error_over_area(0.2), missed_overlap(0.1)}},
    };
}

} // namespace atlas
