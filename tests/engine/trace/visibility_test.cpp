#include "engine/trace/visibility.hpp"
#include "tests/engine/trace/small_world.hpp"

#include <gtest/gtest.h>

#include <atomic>

namespace trace {
namespace {

/// A box above a floor.
struct Yard {
    SmallWorld small;
    ecs::Entity floor = small.add(scene::make_plane({20, 20}));
    ecs::Entity box = small.add(scene::make_box({1, 1, 1}), {0, 2, 0});
    scene::CameraView camera = camera_at({0, 4, 9}, {0, 0.5, 0}, 80, 60);
};

TEST(TraceVisibility, DoesNotDependOnTheNumberOfThreads) {
    Yard yard;
    const TraceScene scene(yard.small.world);
    VisibilityOptions options;
    options.samples = 8;
    options.threads = 1;
    const VisibilityImage one =
        trace_visibility(scene, yard.camera, lamp_at({1, 5, 1}, 0.5), options);
    options.threads = 3;
    const VisibilityImage three =
        trace_visibility(scene, yard.camera, lamp_at({1, 5, 1}, 0.5), options);

    EXPECT_EQ(one.visibility, three.visibility);
    EXPECT_EQ(one.depth, three.depth);
}

TEST(TraceVisibility, OtherSeedsGiveOtherSamplesOfTheSamePenumbra) {
    Yard yard;
    const TraceScene scene(yard.small.world);
    VisibilityOptions options;
    const VisibilityImage one =
        trace_visibility(scene, yard.camera, sun_along({0, -1, 0}, 0.1), options);
    options.seed = 2;
    const VisibilityImage two =
        trace_visibility(scene, yard.camera, sun_along({0, -1, 0}, 0.1), options);

    double sum = 0.0;
    float largest = 0.0F;
    for (std::size_t i = 0; i < one.pixel_count(); ++i) {
        sum += static_cast<double>(one.visibility[i] - two.visibility[i]);
        largest = std::max(largest, std::abs(one.visibility[i] - two.visibility[i]));
    }
    EXPECT_GT(largest, 0.0F);
    EXPECT_LT(largest, 0.2F);
    EXPECT_LT(std::abs(sum), 2.0);
}

TEST(TraceVisibility, SaysWhatEachPixelShows) {
    Yard yard;
    const TraceScene scene(yard.small.world);

    const VisibilityImage image = trace_visibility(scene, yard.camera, sun_along({0, -1, 0}));

    EXPECT_EQ(image.entity[0], ecs::kNoEntity.value);
    EXPECT_EQ(image.visibility[0], 1.0F);
    const std::size_t shadow = [&] {
        const glm::dvec3 at = yard.camera.project({0, 0, 0});
        return image.index(static_cast<int>(at.x), static_cast<int>(at.y));
    }();
    EXPECT_EQ(image.entity[shadow], yard.floor.value);
    EXPECT_EQ(image.patch_id[shadow], 1);
    EXPECT_EQ(image.visibility[shadow], 0.0F);
    EXPECT_NEAR(image.depth[shadow], yard.camera.project({0, 0, 0}).z, 0.2);
    EXPECT_FLOAT_EQ(image.n_dot_l[shadow], 1.0F);
}

TEST(TraceVisibility, ReceiversThatReceiveNothingStayLit) {
    Yard yard;
    yard.small.world.registry.patch<scene::ShadowRole>(
        yard.floor, [](scene::ShadowRole& role) { role.receives = false; });
    const TraceScene scene(yard.small.world);

    const VisibilityImage image = trace_visibility(scene, yard.camera, sun_along({0, -1, 0}));

    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        if (image.entity[i] != yard.floor.value) continue;
        ASSERT_EQ(image.visibility[i], 1.0F);
    }
}

TEST(TraceVisibility, NothingBeforeTheNearPlaneIsSeen) {
    Yard yard;
    const TraceScene scene(yard.small.world);
    scene::CameraView camera = camera_at({0, 6, 0}, {0, 0, 0}, 9, 9);
    EXPECT_EQ(trace_visibility(scene, camera, sun_along({0, -1, 0})).entity[40], yard.box.value);

    camera.near = 4.0F;
    const VisibilityImage image = trace_visibility(scene, camera, sun_along({0, -1, 0}));

    EXPECT_EQ(image.entity[40], yard.floor.value);
    EXPECT_NEAR(image.depth[40], 6.0F, 1e-5F);
}

TEST(TraceVisibility, ReportsProgressOnTheCallingThread) {
    Yard yard;
    const TraceScene scene(yard.small.world);
    VisibilityOptions options;
    options.threads = 1;
    std::vector<double> parts;
    options.progress = [&parts](double part) { parts.push_back(part); };

    trace_visibility(scene, yard.camera, sun_along({0, -1, 0}), options);

    ASSERT_EQ(parts.size(), 60U);
    EXPECT_EQ(parts.back(), 1.0);
}

TEST(Visibility, OfAPointInTheAirCountsEveryDirection) {
    Yard yard;
    const TraceScene scene(yard.small.world);

    EXPECT_EQ(visibility(scene, sun_along({0, -1, 0}), {0, 1, 0}, glm::vec3(0.0F)), 0.0F);
    EXPECT_EQ(visibility(scene, sun_along({0, -1, 0}), {3, 1, 0}, glm::vec3(0.0F)), 1.0F);
    EXPECT_EQ(visibility(scene, sun_along({0, 1, 0}), {0, 1, 0}, glm::vec3(0.0F)), 0.0F);
    EXPECT_EQ(visibility(scene, sun_along({0, 1, 0}), {3, 1, 0}, glm::vec3(0.0F)), 0.0F);
}

TEST(Visibility, LightsThatCastNoShadowReachEverything) {
    Yard yard;
    const TraceScene scene(yard.small.world);
    scene::PlacedLight sun = sun_along({0, -1, 0});
    sun.light.casts_shadow = false;

    EXPECT_EQ(visibility(scene, sun, {0, 0, 0}, {0, 1, 0}), 1.0F);
}

TEST(Visibility, CastersBeyondALampDoNotMatter) {
    Yard yard;
    const TraceScene scene(yard.small.world);

    EXPECT_EQ(visibility(scene, lamp_at({0, 1, 0}), {0, 0, 0}, {0, 1, 0}), 1.0F);
    EXPECT_EQ(visibility(scene, lamp_at({0, 1, 0}, 0.3), {0, 0, 0}, {0, 1, 0}), 1.0F);
    EXPECT_EQ(visibility(scene, lamp_at({0, 4, 0}, 0.3), {0, 0, 0}, {0, 1, 0}), 0.0F);
}

} // namespace
} // namespace trace
