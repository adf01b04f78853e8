// Against another ray tracer that shares no code with this one. It wrote, for each scene, NAME.glb,
// NAME.hard.png (255 lit, 0 dark) and NAME.valid.png (255 where a pixel counts) into the folder
// that GNOMON_PEER_TRUTH names.

#include "engine/core/image.hpp"
#include "engine/scene/gltf.hpp"
#include "engine/trace/visibility.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace trace {
namespace {

constexpr double kAllowedShare = 0.0002;

scene::PlacedLight only_light(const scene::World& world) {
    scene::PlacedLight placed;
    world.registry.each<scene::Light, scene::WorldTransform>(
        [&](ecs::Entity, const scene::Light& light, const scene::WorldTransform& transform) {
            placed.light = light;
            placed.position = transform.world_from_local[3];
            placed.direction = -glm::normalize(glm::dvec3(transform.world_from_local[2]));
        });
    return placed;
}

scene::CameraView only_camera(const scene::World& world, int width, int height) {
    scene::CameraView view;
    world.registry.each<scene::Camera, scene::WorldTransform>(
        [&](ecs::Entity, const scene::Camera& camera, const scene::WorldTransform& transform) {
            view.position = transform.world_from_local[3];
            for (int column = 0; column < 3; ++column)
                view.world_from_view[column] =
                    glm::normalize(glm::dvec3(transform.world_from_local[column]));
            view.fov_y = camera.fov_y;
            view.near = camera.near;
        });
    view.width = width;
    view.height = height;
    return view;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class PeerTruth : public testing::TestWithParam<const char*> {};

TEST_P(PeerTruth, AgreesOnAllButAFewPixels) {
    const char* folder =
        std::getenv("GNOMON_PEER_TRUTH"); // NOLINT(concurrency-mt-unsafe): one thread
    if (folder == nullptr) GTEST_SKIP() << "GNOMON_PEER_TRUTH names no folder of results";
    const std::filesystem::path base = std::filesystem::path(folder) / GetParam();
    auto model = scene::load_gltf(base.string() + ".glb");
    ASSERT_TRUE(model) << to_string(model.error());
    const auto hard = engine::read_png(base.string() + ".hard.png", 1);
    const auto valid = engine::read_png(base.string() + ".valid.png", 1);
    ASSERT_TRUE(hard && valid);
    scene::World world;
    const scene::ModelAssets assets = scene::add_assets(world.assets, std::move(*model));
    scene::instantiate(world, assets, "");
    scene::update(world, 0.0F);

    const auto start = std::chrono::steady_clock::now();
    const TraceScene scene(world);
    const double build = seconds_since(start);
    const auto begin = std::chrono::steady_clock::now();
    const VisibilityImage image =
        trace_visibility(scene, only_camera(world, hard->width, hard->height), only_light(world));
    const double frame = seconds_since(begin);

    int counted = 0;
    int differing = 0;
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        if (valid->bytes[i] != 255) continue;
        ++counted;
        if ((image.visibility[i] > 0.5F) != (hard->bytes[i] > 127)) ++differing;
    }
    std::printf(
        "%s: %zu triangles, build %.2f s, frame %.2f s, %d of %d pixels differ (%.4f %%)\n",
        GetParam(),
        scene.triangle_count(),
        build,
        frame,
        differing,
        counted,
        100.0 * differing / counted);
    EXPECT_GT(counted, 100000);
    EXPECT_LE(differing, kAllowedShare * counted);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes,
    PeerTruth,
    testing::Values("plaza", "plaza_x4", "plaza_x16", "thin", "hero", "room", "grazing", "crowd"),
    [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace trace
