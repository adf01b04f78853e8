// Soft shadows by N points of the light are as wrong as predicted, and no more: 0.35 N^-0.75 of the
// penumbra's width per length of edge.

#include "systems/shadows/light_samples.hpp"
#include "tests/atlas/atlas.hpp"
#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include "tools/gnomon/studio.hpp"

namespace atlas {
namespace {

constexpr double kCardHeight = 2.0;
constexpr double kLampHeight = 4.0;
constexpr double kLampRadius = 0.25;
constexpr double kEyeHeight = 7.0;

/// The shadow of a card, seen from above; as many pixels for a metre everywhere.
Stage card_from_above(int samples) {
    test_support::WorldBuilder builder = test_support::floor_of(20.0F);
    builder.add(
        "card", scene::make_box({1.0F, 0.01F, 1.0F}), test_support::at({0.0, kCardHeight, 0.0}));
    scene::PlacedLight lamp = lamp_at({0.0, kLampHeight, 0.0});
    lamp.light.radius = static_cast<float>(kLampRadius);
    builder.add_light(lamp);
    Stage stage = pinned_stage(
        std::move(builder.world),
        test_support::camera_looking(
            {2.0, kEyeHeight, 0.5}, {2.0, 0.0, 0.4}, kPictureSize, kPictureSize),
        "lamp",
        "floor",
        "planar");
    stage.level.shadows.scene.samples = samples;
    return stage;
}

TEST(LightSamplesOnAFloor, AreAsWrongAsPredicted) {
    if (!gnomon::Studio::open(kPictureSize, kPictureSize)) GTEST_SKIP() << "no OpenGL here";
    const double width_m = 2.0 * kLampRadius * kCardHeight / (kLampHeight - kCardHeight);
    for (const int samples : {4, 16, 64}) {
        SCOPED_TRACE(samples);
        Stage stage = card_from_above(samples);
        const double width_px = width_m / (kEyeHeight * stage.camera.pixel_size());

        const auto seen = observe(stage, {}, "samples_" + std::to_string(samples));

        ASSERT_TRUE(seen) << engine::to_string(seen.error());
        const double found = seen->figures.eps_px.value() / width_px;
        RecordProperty(
            "found_of_predicted_" + std::to_string(samples),
            std::to_string(found / shadows::sampling_error(samples)));
        EXPECT_LT(found, 1.5 * shadows::sampling_error(samples));
        EXPECT_GT(found, 0.3 * shadows::sampling_error(samples));
    }
}

} // namespace
} // namespace atlas
