// Maps are wrong nowhere but near true edges, by what a texel covers there; without their remedies
// they are.

#include "tests/atlas/atlas.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include "tools/gnomon/studio.hpp"

namespace atlas {
namespace {

using shadows::Remedy;
using test_support::at;

/// Solids of every slant on a floor that itself throws a shadow on the one below.
Stage yard(const std::string& filter) {
    test_support::WorldBuilder builder = test_support::floor_of(12.0F);
    builder.add("basement", scene::make_plane(glm::vec2(60.0F)), at({0.0, -3.0, 0.0}));
    builder.add("box", scene::make_box(glm::vec3(1.0F)), at({-1.5, 0.5, 0.0}));
    builder.add("ball", scene::make_sphere(0.8F), at({1.2, 1.2, 0.5}));
    builder.add("lantern", scene::make_sphere(0.7F, 12), at({-2.6, 0.9, 1.6}));
    builder.add("ring", scene::make_torus(0.8F, 0.25F), at({0.0, 0.25, 2.0}));
    builder.add_light(test_support::sun_at(32.0, 40.0));
    Stage stage;
    stage.level.world = std::move(builder.world);
    stage.level.shadows.scene.technique = "cascaded_map";
    stage.level.shadows.scene.map_size = 1024;
    stage.level.shadows.scene.filter = filter;
    stage.camera = test_support::usual_camera(kPictureSize);
    stage.light = "sun";
    return stage;
}

class MapInterior : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        if (!gnomon::Studio::open(kPictureSize, kPictureSize)) GTEST_SKIP() << "no OpenGL here";
    }
};

TEST_P(MapInterior, IsRightOutsideTheBandAndWrongWithoutTheReceiversPlane) {
    Stage stage = yard(GetParam());
    const auto right = observe(stage, {}, "interior_" + GetParam());
    ASSERT_TRUE(right) << engine::to_string(right.error());
    const auto wrong = observe(
        stage,
        shadows::Remedies().without(Remedy::map_receiver_plane),
        "interior_" + GetParam() + "_off");
    ASSERT_TRUE(wrong) << engine::to_string(wrong.error());

    EXPECT_LT(right->figures.band_share.value(), 0.25);
    EXPECT_EQ(right->figures.far_false_shadow_px.value(), 0.0);
    EXPECT_EQ(right->figures.far_light_leak_px.value(), 0.0);
    EXPECT_GT(wrong->figures.far_false_shadow_px.value(), 100.0);
}

INSTANTIATE_TEST_SUITE_P(
    Filters,
    MapInterior,
    testing::Values("bilinear", "pcf"),
    [](const testing::TestParamInfo<std::string>& tested) { return tested.param; });

} // namespace
} // namespace atlas
