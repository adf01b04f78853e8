// Shadows whose shape is known on paper.

#include "engine/trace/visibility.hpp"
#include "tests/engine/trace/small_world.hpp"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace trace {
namespace {

constexpr double kPi = glm::pi<double>();
constexpr glm::vec3 kUp = {0, 1, 0};

/// Whether a sphere stands between a point and the sun: its centre is nearer to the ray than its
/// radius.
bool sphere_hides_sun(
    const glm::dvec3& point, const glm::dvec3& to_sun, const glm::dvec3& centre, double radius) {
    const glm::dvec3 to_centre = centre - point;
    return glm::dot(to_centre, to_sun) > 0.0 && glm::length(glm::cross(to_centre, to_sun)) < radius;
}

/// Common area of two circles at a distance from each other.
double lens_area(double r, double s, double distance) {
    if (distance >= r + s) return 0.0;
    if (distance <= std::abs(r - s)) return kPi * std::min(r, s) * std::min(r, s);
    const double a = (distance * distance + r * r - s * s) / (2.0 * distance);
    const double b = distance - a;
    return r * r * std::acos(a / r) - a * std::sqrt(r * r - a * a) + s * s * std::acos(b / s)
           - b * std::sqrt(s * s - b * b);
}

TEST(ClosedForm, ASpheresHardShadowIsItsEllipseToThePixel) {
    SmallWorld small;
    const ecs::Entity floor = small.add(scene::make_plane({40, 40}));
    small.add(scene::make_sphere(0.5F, 200), {0, 2, 0});
    const TraceScene scene(small.world);
    const scene::CameraView camera = camera_at({0, 3, 8}, {0, 0.5, 0}, 192, 192);
    const scene::PlacedLight sun = sun_along({0.6, -1, -0.2});
    const glm::dvec3 to_sun = -glm::dvec3(sun.direction);
    const VisibilityImage image = trace_visibility(scene, camera, sun);

    const auto expected = [&](double x, double y) {
        const glm::dvec3 direction = camera.ray_direction(x, y);
        const double t = -camera.position.y / direction.y;
        return !sphere_hides_sun(camera.position + t * direction, to_sun, {0, 2, 0}, 0.5);
    };
    int dark = 0;
    int differing = 0;
    int differing_inside = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            if (image.entity[image.index(x, y)] != floor.value) continue;
            const bool lit = image.visibility[image.index(x, y)] == 1.0F;
            if (!lit) ++dark;
            if (lit == expected(x + 0.5, y + 0.5)) continue;
            ++differing;
            // Beyond a pixel from the edge all corners of the pixel agree with its centre.
            if (expected(x, y) != lit && expected(x + 1, y) != lit && expected(x, y + 1) != lit
                && expected(x + 1, y + 1) != lit)
                ++differing_inside;
        }

    EXPECT_GT(dark, 80);
    EXPECT_LE(differing, 2);
    EXPECT_EQ(differing_inside, 0);
}

TEST(ClosedForm, ADiscEclipsesTheSunByTheLensOfTwoCircles) {
    SmallWorld small;
    small.add(scene::make_cylinder(0.02F, 1e-5F, 256), {0, 2, 0});
    const TraceScene scene(small.world);
    const double sun_radius = 0.015;
    const scene::PlacedLight sun = sun_along({0, -1, 0}, sun_radius);

    for (const double aside : {0.0, 0.008, 0.02, 0.03, 0.04, 0.06}) {
        SCOPED_TRACE(aside);
        const double hidden =
            lens_area(sun_radius, 0.01, aside / 2.0) / (kPi * sun_radius * sun_radius);
        const float seen = visibility(scene, sun, {aside, 0, 0}, kUp, 4096);
        EXPECT_NEAR(seen, 1.0 - hidden, 0.003);
    }
}

TEST(ClosedForm, APenumbraIsAsWideAsTheSunAndTheHeightMakeIt) {
    SmallWorld small;
    small.add(scene::make_box({20, 1e-3F, 20}), {-10, 4, 0});
    const TraceScene scene(small.world);
    const double angle = 0.05;
    const scene::PlacedLight sun = sun_along({0, -1, 0}, angle);
    const double half_width = 4.0 * std::tan(angle);

    EXPECT_EQ(visibility(scene, sun, {-1.01 * half_width, 0, 0}, kUp, 1024), 0.0F);
    EXPECT_GT(visibility(scene, sun, {-0.95 * half_width, 0, 0}, kUp, 1024), 0.0F);
    EXPECT_NEAR(visibility(scene, sun, {0, 0, 0}, kUp, 1024), 0.5, 0.01);
    EXPECT_LT(visibility(scene, sun, {0.95 * half_width, 0, 0}, kUp, 1024), 1.0F);
    EXPECT_EQ(visibility(scene, sun, {1.01 * half_width, 0, 0}, kUp, 1024), 1.0F);
}

TEST(ClosedForm, ALampsPenumbraEndsAtTheTangentsOfItsSphere) {
    SmallWorld small;
    small.add(scene::make_box({20, 1e-4F, 20}), {-10, 2, 0});
    const TraceScene scene(small.world);
    const scene::PlacedLight lamp = lamp_at({0, 5, 0}, 0.5);
    const double half_width = 2.0 * std::tan(std::asin(0.5 / 3.0));

    EXPECT_EQ(visibility(scene, lamp, {-1.01 * half_width, 0, 0}, kUp, 1024), 0.0F);
    EXPECT_GT(visibility(scene, lamp, {-0.95 * half_width, 0, 0}, kUp, 1024), 0.0F);
    EXPECT_NEAR(visibility(scene, lamp, {0, 0, 0}, kUp, 1024), 0.5, 0.01);
    EXPECT_LT(visibility(scene, lamp, {0.95 * half_width, 0, 0}, kUp, 1024), 1.0F);
    EXPECT_EQ(visibility(scene, lamp, {1.01 * half_width, 0, 0}, kUp, 1024), 1.0F);
}

TEST(ClosedForm, TheHorizonHidesPartOfTheSunWithoutMakingShadow) {
    SmallWorld small;
    small.add(scene::make_plane({10, 10}));
    const TraceScene scene(small.world);

    EXPECT_EQ(visibility(scene, sun_along({1, -0.02, 0}, 0.1), {0, 0, 0}, kUp, 256), 1.0F);
    EXPECT_EQ(visibility(scene, sun_along({1, 0.5, 0}, 0.1), {0, 0, 0}, kUp, 256), 0.0F);
}

struct Place {
    const char* name;
    glm::dvec3 position;
    double offset_scale;
};

void PrintTo(const Place& place, std::ostream* out) {
    *out << place.name;
}

class ConvexBody : public testing::TestWithParam<Place> {};

TEST_P(ConvexBody, NeverShadowsItsOwnLitSide) {
    SmallWorld small;
    const glm::dvec3 centre = GetParam().position;
    small.add(scene::make_sphere(1.0F, 100), centre);
    small.add(scene::make_box({1, 1, 1}), centre + glm::dvec3(3, 0, 0));
    const TraceScene scene(small.world);
    const scene::CameraView camera = camera_at(centre + glm::dvec3(1, 3, 7), centre, 160, 120);
    VisibilityOptions options;
    options.offset = GetParam().offset_scale * scene.default_offset();
    int lit_side = 0;
    int wrong = 0;
    for (const glm::dvec3 direction :
         {glm::dvec3(0, -0.4, -1), glm::dvec3(0, -1, 0.01), glm::dvec3(0.01, -0.1, 1)}) {
        const VisibilityImage image =
            trace_visibility(scene, camera, sun_along(direction), options);
        for (std::size_t i = 0; i < image.pixel_count(); ++i) {
            if (!(image.n_dot_l[i] > 0.0F)) continue;
            ++lit_side;
            if (image.visibility[i] != 1.0F) ++wrong;
        }
    }

    EXPECT_GT(lit_side, 1000);
    EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Places,
    ConvexBody,
    testing::Values(
        Place{"AtTheOrigin", {0, 0, 0}, 1.0},
        Place{"WithATinyOffset", {0, 0, 0}, 1e-3},
        Place{"WithALargeOffset", {0, 0, 0}, 100.0},
        Place{"AtAnOddPlace", {70.1, 5.3, -90.7}, 1.0},
        Place{"AHundredKilometresAway", {1e5, 0, -1e5}, 1.0},
        Place{"AHundredKilometresAwayWithATinyOffset", {1e5, 0, -1e5}, 1e-3}),
    [](const auto& place) { return std::string(place.param.name); });

TEST(ClosedForm, AHundredKilometresAwayThePictureIsTheSame) {
    const auto picture = [](const glm::dvec3& centre) {
        SmallWorld small;
        small.add(scene::make_plane({40, 40}), centre);
        small.add(scene::make_torus(1.0F, 0.25F), centre + glm::dvec3(0, 1, 0));
        const TraceScene scene(small.world);
        return trace_visibility(
            scene,
            camera_at(centre + glm::dvec3(0, 3, 8), centre, 160, 120),
            sun_along({0.3, -1, -0.2}));
    };

    const VisibilityImage here = picture({0, 0, 0});
    const VisibilityImage there = picture({131072, 0, -131072});

    EXPECT_EQ(here.visibility, there.visibility);
    EXPECT_EQ(here.entity, there.entity);
}

} // namespace
} // namespace trace
