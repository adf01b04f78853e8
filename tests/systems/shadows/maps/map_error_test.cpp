#include "systems/shadows/maps/map_error.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shadows {
namespace {

constexpr double kTexelOfOne = 10.0; // metres

/// A box over a floor, one metre apart, under a sun of a size.
struct Soft {
    explicit Soft(double angular_radius_deg) {
        scene.lights[0].light.angular_radius = static_cast<float>(glm::radians(angular_radius_deg));
        casters.bounds = scene.casters[0].bounds;
        casters.casters = {0};
        casters.triangles = 12;
    }
    [[nodiscard]] PairView pair() const {
        return {scene, scene.lights[0], scene.receivers[0], wish, budget_px};
    }
    [[nodiscard]] Prediction predicted(const char* filter) {
        wish.filter = filter;
        return *predict_map(pair(), casters, kTexelOfOne, 1);
    }

    ShadowScene scene = box_over_floor();
    CasterGroup casters;
    scene::ShadowWish wish;
    double budget_px = 1.0;
};

TEST(MapError, APenumbraCostsASoftFilterFarLessThanAHardOne) {
    Soft soft(4.0);
    soft.wish.map_size = 2048;

    EXPECT_LT(soft.predicted("pcss").error_px, soft.predicted("bilinear").error_px * 0.25);
}

TEST(MapError, ASoftFilterTakesManyMoreTaps) {
    Soft soft(4.0);

    EXPECT_GT(soft.predicted("pcss").cost.taps, soft.predicted("pcf").cost.taps * 2.0);
}

TEST(MapError, MoreTapsMeanLessError) {
    Soft soft(4.0);
    soft.wish.map_size = 2048;
    soft.wish.samples = 16;
    const Prediction few = soft.predicted("pcss");
    soft.wish.samples = 64;
    const Prediction many = soft.predicted("pcss");

    EXPECT_LT(many.error_px, few.error_px);
    EXPECT_GT(many.cost.taps, few.cost.taps * 3.0);
}

TEST(MapError, MoreTexelsAreNotSpentOnWhatTapsCost) {
    Soft soft(8.0);
    soft.wish.samples = 4;

    EXPECT_GT(soft.predicted("pcss").error_px, soft.budget_px);
    EXPECT_LT(map_size_for(soft.pair(), soft.casters, MapFilter::pcss, kTexelOfOne), kLargestMap);
}

TEST(MapError, AHardLightIsNeverFilteredSoftly) {
    Soft hard(0.0);
    hard.wish.filter = "pcss";

    EXPECT_EQ(*map_filter(hard.pair(), hard.casters, kTexelOfOne), MapFilter::bilinear);
}

TEST(MapError, WhereNoFilterIsWishedTheBudgetDecides) {
    Soft wide(4.0);
    Soft narrow(0.05);

    EXPECT_EQ(*map_filter(wide.pair(), wide.casters, kTexelOfOne), MapFilter::pcss);
    EXPECT_EQ(*map_filter(narrow.pair(), narrow.casters, kTexelOfOne), MapFilter::bilinear);
}

TEST(MapError, AFilterThatMapsDoNotHaveIsAnError) {
    Soft soft(1.0);
    soft.wish.filter = "vsm";

    EXPECT_FALSE(map_filter(soft.pair(), soft.casters, kTexelOfOne));
}

} // namespace
} // namespace shadows
