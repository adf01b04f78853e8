#include "engine/core/image.hpp"
#include "tests/engine/trace/small_world.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <numeric>

#include "tools/truth/truth.hpp"
#include "tools/truth/truth_files.hpp"

namespace truth {
namespace {

using trace::camera_at;
using trace::SmallWorld;
using trace::sun_along;

/// A box above a floor, seen from above at an odd angle.
struct Yard {
    SmallWorld small;
    ecs::Entity floor = small.add(scene::make_plane({20, 20}));
    ecs::Entity box = small.add(scene::make_box({2, 1, 2}), {0, 2, 0});
    scene::CameraView camera = camera_at({1, 4, 9}, {0, 0.5, 0}, 96, 72);
    scene::PlacedLight sun = sun_along({0.31, -1, -0.17});
    trace::TraceScene traced{small.world};
};

int count(const std::vector<std::uint8_t>& marks) {
    return std::accumulate(marks.begin(), marks.end(), 0);
}

TEST(Truth, UndecidedPixelsAreFewAndLieOnEdges) {
    Yard yard;

    const TruthImage truth = true_visibility(yard.traced, yard.camera, yard.sun);

    const Shares parts = shares(truth);
    EXPECT_GT(count(truth.undecided), 0);
    EXPECT_LT(parts.undecided, 0.01);
    EXPECT_EQ(parts.undecided_inside, 0.0);
    EXPECT_GT(parts.shadow, 0.01);
}

TEST(Truth, LookingOnlyNearEdgesFindsWhatLookingEverywhereFinds) {
    Yard yard;
    TruthOptions everywhere;
    everywhere.all_pixels = true;

    const TruthImage near = true_visibility(yard.traced, yard.camera, yard.sun);
    const TruthImage all = true_visibility(yard.traced, yard.camera, yard.sun, everywhere);

    EXPECT_EQ(near.undecided, all.undecided);
}

TEST(Truth, AnEdgeThroughPixelCentresIsUndecided) {
    SmallWorld small;
    small.add(scene::make_plane({20, 20}));
    // Seen from straight above, the shadow of the box ends on the column of pixel centres at x = 0.
    small.add(scene::make_box({4, 1, 20}), {-2, 1, 0});
    const trace::TraceScene traced(small.world);
    scene::CameraView camera = camera_at({0, 0.4, 0}, {0, 0, 0}, 21, 21);

    const TruthImage truth = true_visibility(traced, camera, sun_along({0, -1, 0}));

    for (int y = 0; y < 21; ++y) {
        SCOPED_TRACE(y);
        EXPECT_EQ(truth.undecided[truth.image.index(10, y)], 1);
        EXPECT_EQ(truth.undecided[truth.image.index(8, y)], 0);
        EXPECT_EQ(truth.undecided[truth.image.index(12, y)], 0);
    }
}

TEST(Truth, ACrackThinnerThanTheOffsetsIsUndecided) {
    SmallWorld small;
    small.add(scene::make_plane({20, 20}));
    TruthOptions options;
    options.visibility.offset = 1e-3;
    // A second sheet, higher than one offset and lower than four, hides the first from the sun.
    const ecs::Entity sheet = small.add(scene::make_plane({4, 4}), {0, 2e-3, 0});
    small.world.registry.patch<scene::WorldTransform>(sheet, [](scene::WorldTransform& transform) {
        transform.world_from_local[1] = -transform.world_from_local[1];
        transform.world_from_local[0] =
            -transform.world_from_local[0]; // turned over: seen from below only
    });
    const trace::TraceScene traced(small.world);
    const scene::CameraView camera = camera_at({0, 5, 0.1}, {0, 0, 0}, 32, 32);
    options.all_pixels = true;

    const TruthImage truth = true_visibility(traced, camera, sun_along({0, -1, 0}), options);

    const std::size_t middle = truth.image.index(16, 16);
    EXPECT_EQ(truth.image.visibility[middle], 0.0F);
    EXPECT_EQ(truth.undecided[middle], 1);
    EXPECT_EQ(truth.undecided[0], 0);
}

/// A wire a tenth of a pixel thick, high above a floor that is seen from straight above.
struct Wire {
    SmallWorld small;
    scene::CameraView camera = camera_at({0, 10, 0.001}, {0, 0, 0}, 64, 64);
    double pixel = 10.0 * camera.pixel_size();
    scene::PlacedLight sun = sun_along({1, -1, 0});

    Wire() {
        small.add(scene::make_plane({20, 20}));
        small.add(
            scene::make_box({static_cast<float>(0.1 * pixel), 0.001F, 20.0F}),
            glm::dvec3(-1.0 + 0.25 * pixel, 1.0, 0.0));
    }
};

TEST(EdgeNear, FindsTheShadowOfAWireThatNoPixelShows) {
    Wire wire;
    const trace::TraceScene traced(wire.small.world);
    const TruthImage truth = true_visibility(traced, wire.camera, wire.sun);
    const auto found = [&](double x, double radius) {
        return edge_near(traced, wire.camera, wire.sun, {x, 40.5}, true, radius, 0.0);
    };

    // The shadow falls a quarter of a pixel right of the picture's middle, which is the corner of
    // four pixels.
    EXPECT_EQ(truth.image.visibility[truth.image.index(32, 40)], 1.0F);
    EXPECT_TRUE(found(32.5, 1.0));
    EXPECT_TRUE(found(34.5, 3.0));
    EXPECT_FALSE(found(34.5, 1.0));
    EXPECT_FALSE(found(38.5, 3.0));
}

TEST(SecondGrid, IsHalfAPixelRightOfAndBelowTheFirst) {
    Yard yard;
    scene::CameraView finer = yard.camera;
    finer.width *= 2;
    finer.height *= 2;

    const auto second = second_grid(yard.traced, yard.camera, yard.sun, {});

    // Centres of a picture twice as fine lie a quarter of a pixel off either grid: corners of
    // pixels are where four of them meet.
    const TruthImage fine = true_visibility(yard.traced, finer, yard.sun);
    std::size_t same = 0;
    for (int y = 0; y + 1 < second.height; ++y)
        for (int x = 0; x + 1 < second.width; ++x)
            if (second.visibility[second.index(x, y)]
                == fine.image.visibility[fine.image.index(2 * x + 2, 2 * y + 2)])
                ++same;
    EXPECT_GT(static_cast<double>(same), 0.97 * static_cast<double>(second.pixel_count()));
    const auto corner = trace::trace_pixel(yard.traced, yard.camera, yard.sun, {11.0, 51.0}, {});
    ASSERT_TRUE(corner.hit);
    EXPECT_EQ(second.depth[second.index(10, 50)], static_cast<float>(corner.hit->t));
}

TEST(Validity, NeedsTheSameEntityAtTheSameDepth) {
    Yard yard;
    const TruthImage truth = true_visibility(yard.traced, yard.camera, yard.sun);
    std::vector<std::uint32_t> ids = truth.image.entity;
    std::vector<float> depth = truth.image.depth;
    const std::size_t centre = truth.image.index(48, 60);
    ASSERT_EQ(ids[centre], yard.floor.value);
    const int before = count(validity(truth, ids, depth));

    depth[centre] *= 1.0005F;
    EXPECT_EQ(count(validity(truth, ids, depth)), before);
    depth[centre] *= 1.001F;
    EXPECT_EQ(count(validity(truth, ids, depth)), before - 1);
    ids[centre + 1] = yard.box.value;
    EXPECT_EQ(count(validity(truth, ids, depth)), before - 2);
    EXPECT_EQ(validity(truth, ids, depth)[0], 0) << "nothing is hit there";
}

TEST(TruthFiles, HoldTheMaskTheValidPixelsAndTheShares) {
    Yard yard;
    const TruthImage truth = true_visibility(yard.traced, yard.camera, yard.sun);
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "truth_files";
    std::filesystem::create_directories(folder);

    const auto written = write_truth(folder, "sun", truth);

    ASSERT_TRUE(written) << to_string(written.error());
    const auto mask = engine::read_png(folder / "truth_sun.png", 1);
    const auto valid = engine::read_png(folder / "truth_sun_valid.png", 1);
    ASSERT_TRUE(mask && valid);
    int undecided = 0;
    for (std::size_t i = 0; i < truth.image.pixel_count(); ++i) {
        ASSERT_EQ(mask->bytes[i], truth.image.visibility[i] > 0.5F ? 255 : 0);
        if (valid->bytes[i] == 64) ++undecided;
    }
    EXPECT_EQ(undecided, count(truth.undecided));
    std::ifstream file(folder / "truth_sun.json");
    const auto json = nlohmann::json::parse(file);
    EXPECT_EQ(json["size"], (std::vector<int>{96, 72}));
    EXPECT_DOUBLE_EQ(json["shares"]["undecided"].get<double>(), shares(truth).undecided);
}

TEST(TruthFiles, AMissingFolderIsAnError) {
    EXPECT_FALSE(
        write_truth("/no/such/folder", "sun", TruthImage{trace::VisibilityImage(1, 1), {0}}));
}

} // namespace
} // namespace truth
