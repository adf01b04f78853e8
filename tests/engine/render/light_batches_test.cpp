#include "engine/render/light_batches.hpp"

#include <gtest/gtest.h>
#include <render/shared/lights.h>

#include <vector>

namespace render {
namespace {

std::vector<scene::PlacedLight>
lights(std::size_t count, scene::LightKind kind = scene::LightKind::point) {
    std::vector<scene::PlacedLight> all(count);
    for (scene::PlacedLight& light : all)
        light.light.kind = kind;
    return all;
}

gpu::Rect column(int index) {
    return {index * 10, 0, 10, 100};
}

TEST(BatchLights, MasksThatDoNotOverlapShareALayer) {
    const std::vector<gpu::Rect> areas = {column(0), column(1), column(2)};

    const auto batches = batch_lights(lights(3), areas, {true, true, true});

    ASSERT_EQ(batches.size(), 1U);
    EXPECT_EQ(batches[0].layer_count, 1);
}

TEST(BatchLights, MasksThatOverlapDoNot) {
    const std::vector<gpu::Rect> areas = {{0, 0, 20, 20}, {19, 19, 20, 20}};

    const auto batches = batch_lights(lights(2), areas, {true, true});

    EXPECT_EQ(batches[0].layer_count, 2);
    EXPECT_NE(batches[0].lights[0].layer, batches[0].lights[1].layer);
}

TEST(BatchLights, LightsWithoutMasksTakeNoLayer) {
    const std::vector<gpu::Rect> areas(5, gpu::Rect{0, 0, 10, 10});

    const auto batches = batch_lights(lights(5), areas, std::vector<bool>(5, false));

    ASSERT_EQ(batches.size(), 1U);
    EXPECT_EQ(batches[0].layer_count, 0);
}

TEST(BatchLights, ANewBatchBeginsWhenLayersRunOut) {
    const std::vector<gpu::Rect> areas(MAX_MASK_LAYERS + 1, gpu::Rect{0, 0, 10, 10});

    const auto batches =
        batch_lights(lights(areas.size()), areas, std::vector<bool>(areas.size(), true));

    ASSERT_EQ(batches.size(), 2U);
    EXPECT_EQ(batches[0].lights.size(), std::size_t{MAX_MASK_LAYERS});
    EXPECT_EQ(batches[1].lights.size(), 1U);
}

TEST(BatchLights, LightsOutOfViewAreLeftOutAndDirectionalOnesComeFirst) {
    auto mixed = lights(3);
    mixed[2].light.kind = scene::LightKind::directional;
    const std::vector<gpu::Rect> areas = {{}, {0, 0, 5, 5}, {0, 0, 10, 10}};

    const auto batches = batch_lights(mixed, areas, std::vector<bool>(3, false));

    ASSERT_EQ(batches[0].lights.size(), 2U);
    EXPECT_EQ(batches[0].lights[0].light, 2U);
    EXPECT_EQ(batches[0].lights[1].light, 1U);
}

TEST(BatchLights, NoLightsAreStillOneBatch) {
    EXPECT_EQ(batch_lights({}, {}, {}).size(), 1U);
}

TEST(LightTiles, CoverEveryPixelOnceWithItsLights) {
    LightBatch batch;
    batch.lights = {
        {0, {0, 0, 200, 150}, {}}, {1, {30, 40, 50, 60}, {}}, {2, {190, 140, 10, 10}, {}}};
    std::vector<int> covered(200 * 150);

    for (const LightTile& tile : light_tiles(batch, 200, 150))
        for (unsigned y = tile.rectangle.y; y < tile.rectangle.w; ++y)
            for (unsigned x = tile.rectangle.x; x < tile.rectangle.z; ++x) {
                ++covered[y * 200 + x];
                const auto inside = [&](const gpu::Rect& area) {
                    const int px = static_cast<int>(x);
                    const int py = static_cast<int>(y);
                    return px >= area.x && px < area.x + area.width && py >= area.y
                           && py < area.y + area.height;
                };
                for (std::size_t i = 0; i < batch.lights.size(); ++i)
                    ASSERT_TRUE(!inside(batch.lights[i].area) || ((tile.bits >> i) & 1U) != 0)
                        << x << ' ' << y;
            }

    for (const int times : covered)
        ASSERT_EQ(times, 1);
}

TEST(LightTiles, OneLightEverywhereIsOneTile) {
    LightBatch batch;
    batch.lights = {{0, {0, 0, 1280, 720}, {}}};

    EXPECT_EQ(light_tiles(batch, 1280, 720).size(), 1U);
}

TEST(ScreenRect, HoldsEveryPointThatALampReaches) {
    scene::CameraView camera;
    camera.width = 400;
    camera.height = 300;
    auto light = lights(1).front();
    light.light.range = 2.0F;
    light.position = {1.0, 0.5, -10.0};

    const gpu::Rect rect = screen_rect(camera, light);

    EXPECT_LT(rect.width, 400);
    for (int i = 0; i < 200; ++i) {
        const double a = i * 0.7;
        const glm::dvec3 on_sphere(
            std::cos(a) * std::cos(i), std::sin(i), std::sin(a) * std::cos(i));
        const glm::dvec3 at = camera.project(light.position + 2.0 * on_sphere);
        EXPECT_GE(at.x, rect.x);
        EXPECT_LE(at.x, rect.x + rect.width);
        EXPECT_GE(300.0 - at.y, rect.y);
        EXPECT_LE(300.0 - at.y, rect.y + rect.height);
    }
}

TEST(ScreenRect, IsEmptyBehindTheCameraAndWholeAroundIt) {
    scene::CameraView camera;
    auto light = lights(1).front();
    light.light.range = 2.0F;
    light.position = {0.0, 0.0, 10.0};
    EXPECT_TRUE(screen_rect(camera, light).empty());

    light.position = {0.0, 0.0, 1.0};
    EXPECT_EQ(screen_rect(camera, light), (gpu::Rect{0, 0, camera.width, camera.height}));
}

} // namespace
} // namespace render
