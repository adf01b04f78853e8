#include "systems/shadows/maps/cascade_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadows {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

scene::CameraView camera_at(const glm::dvec3& position, double yaw_degrees = 0.0) {
    scene::CameraView camera;
    camera.position = position;
    const auto yaw = static_cast<float>(yaw_degrees * kDegree);
    camera.world_from_view = glm::mat3(
        glm::vec3(std::cos(yaw), 0.0F, -std::sin(yaw)),
        glm::vec3(0.0F, 1.0F, 0.0F),
        glm::vec3(std::sin(yaw), 0.0F, std::cos(yaw)));
    return camera;
}

/// A wide court under a sun at 40 degrees.
struct Court {
    glm::dvec3 origin = {};
    Remedies remedies;
    glm::dmat3 axes =
        light_axes(glm::normalize(glm::dvec3(0.6, -0.7, 0.4)), std::nullopt, remedies);

    [[nodiscard]] std::vector<ParallelView>
    fit(const scene::CameraView& camera, const Remedies& with) const {
        const engine::WorldAabb all{
            origin + glm::dvec3(-2000.0, 0.0, -2000.0), origin + glm::dvec3(2000.0, 12.0, 2000.0)};
        const CascadeRequest request{camera, axes, all, {&all, 1}, {4.0, 128.0}, 3, 1024};
        return fit_cascades(request, with);
    }
};

/// How far, in texels, a texel's corner lies from the grid that another view draws.
double off_grid(const ParallelView& a, const ParallelView& b) {
    const glm::dvec2 texels = (a.min - b.min) / b.texel;
    const glm::dvec2 off = glm::abs(texels - glm::round(texels));
    return std::max(off.x, off.y);
}

/// The largest off_grid between neighbours of a walk.
double shimmer_of_walk(const Court& court, const Remedies& remedies) {
    double worst = 0.0;
    auto before = court.fit(camera_at(court.origin + glm::dvec3(0.0, 1.7, 0.0)), remedies);
    for (int frame = 1; frame <= 64; ++frame) {
        const glm::dvec3 at(0.0167 * frame, 1.7, -0.0162 * frame); // 1.4 m/s at 60 Hz
        const auto now = court.fit(camera_at(court.origin + at), remedies);
        for (std::size_t i = 0; i < now.size(); ++i)
            worst = std::max(worst, off_grid(now[i], before[i]));
        before = now;
    }
    return worst;
}

TEST(CascadeFit, AWalkMovesTexelsByWholeTexels) {
    const Court court;
    EXPECT_LT(shimmer_of_walk(court, {}), 1e-6);
}

TEST(CascadeFit, WithoutSnappingAWalkMovesThemByParts) {
    const Court court;
    EXPECT_GT(shimmer_of_walk(court, Remedies().without(Remedy::map_snapped_texels)), 0.2);
}

double size_change_of_turn(const Court& court, const Remedies& remedies) {
    double worst = 0.0;
    const auto first = court.fit(camera_at({0.0, 1.7, 0.0}), remedies);
    for (int degree = 1; degree <= 64; ++degree) {
        const auto now = court.fit(camera_at({0.0, 1.7, 0.0}, degree), remedies);
        for (std::size_t i = 0; i < now.size(); ++i)
            worst = std::max(worst, std::abs(now[i].texel.x / first[i].texel.x - 1.0));
    }
    return worst;
}

TEST(CascadeFit, ATurnKeepsTheSizeOfTexels) {
    EXPECT_LT(size_change_of_turn(Court(), {}), 1e-12);
}

TEST(CascadeFit, WithATightFitTexelsBreathe) {
    EXPECT_GT(size_change_of_turn(Court(), Remedies().without(Remedy::map_constant_size)), 0.05);
}

/// The largest angle between right axes of neighbours while the sun passes the vertical, degrees.
double turn_at_vertical(const Remedies& remedies) {
    double worst = 0.0;
    std::optional<glm::dmat3> before;
    for (int step = -150; step <= 150; ++step) {
        const double tilt = 0.01 * step * kDegree;
        const glm::dvec3 direction(std::sin(tilt), -std::cos(tilt), 0.003);
        const glm::dmat3 axes = light_axes(glm::normalize(direction), before, remedies);
        if (before) {
            const double cosine = glm::dot(glm::transpose(axes)[0], glm::transpose(*before)[0]);
            worst = std::max(worst, std::acos(std::clamp(cosine, -1.0, 1.0)) / kDegree);
        }
        before = axes;
    }
    return worst;
}

TEST(CascadeFit, TheMapDoesNotTurnWhenTheSunPassesTheVertical) {
    EXPECT_LT(turn_at_vertical({}), 0.1);
}

TEST(CascadeFit, WithAChangingUpItTurns) {
    EXPECT_GT(turn_at_vertical(Remedies().without(Remedy::map_steady_up)), 1.0);
}

TEST(CascadeFit, AxesArePerpendicularForEveryDirection) {
    for (int i = 0; i < 200; ++i) {
        const double z = -1.0 + (i + 0.5) / 100.0;
        const double angle = 2.4 * i;
        const double r = std::sqrt(1.0 - z * z);
        const glm::dvec3 direction(r * std::cos(angle), z, r * std::sin(angle));
        const glm::dmat3 axes = light_axes(direction, std::nullopt, {});
        const glm::dmat3 identity = axes * glm::transpose(axes);
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                EXPECT_NEAR(identity[column][row], column == row ? 1.0 : 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(glm::transpose(axes)[2], direction), 1.0, 1e-12);
    }
}

TEST(CascadeFit, AHundredKilometresAwayTexelsStayOnTheGrid) {
    Court court;
    court.origin = {1e5, 0.0, 1e5};
    EXPECT_LT(shimmer_of_walk(court, {}), 1e-5);
    EXPECT_GT(shimmer_of_walk(court, Remedies().without(Remedy::map_near_origin)), 0.02);
}

TEST(CascadeFit, EveryCascadeHoldsItsSliceOfTheView) {
    const Court court;
    const scene::CameraView camera = camera_at({3.0, 1.7, 5.0}, 30.0);
    const auto views = court.fit(camera, {});
    ASSERT_EQ(views.size(), 3U);
    const auto depths = split_depths({4.0, 128.0}, 3);
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (double x : {0.0, 1280.0}) {
            for (double y : {0.0, 720.0}) {
                glm::dvec3 point = camera.position + camera.ray_direction(x, y) * depths[i];
                // Receivers lie between the ground and 12 m.
                point.y = std::clamp(point.y, 0.0, 12.0);
                const glm::dvec3 map = views[i].map_from_world() * glm::dvec4(point, 1.0);
                EXPECT_GE(std::min(map.x, map.y), 0.0) << i;
                EXPECT_LE(std::max(map.x, map.y), 1.0) << i;
            }
        }
    }
}

TEST(CascadeFit, TheSliceOfADepthEndsWhereTheSplitsSay) {
    const DepthRange range{0.5, 200.0};
    const auto ends = split_depths(range, 4);
    for (const double depth : {0.1, 0.6, 3.0, 9.0, 42.0, 199.0, 900.0}) {
        const auto end =
            std::find_if(ends.begin(), ends.end(), [&](double far) { return far >= depth; });
        EXPECT_NEAR(
            slice_end(range, 4, depth), end == ends.end() ? ends.back() : *end, 1e-9 * range.far);
    }
}

TEST(CascadeFit, ALowSunsTexelsShrinkWithTheGround) {
    Court low;
    low.axes = light_axes(glm::normalize(glm::dvec3(1.0, -0.1, 0.0)), std::nullopt, {});
    const auto views = low.fit(camera_at({0.0, 1.7, 0.0}), {});
    EXPECT_LT(views.front().texel.y, 0.8 * views.front().texel.x);
    EXPECT_LT(views.back().texel.y, 0.4 * views.back().texel.x);
}

TEST(CascadeFit, ASmallSceneIsCoveredWholeWhateverTheCameraDoes) {
    const Court court;
    const engine::WorldAabb receivers{{-8.0, 0.0, -8.0}, {8.0, 3.0, 8.0}};
    const engine::WorldAabb caster{{-1.0, 0.0, -1.0}, {1.0, 2.0, 1.0}};
    const scene::CameraView near = camera_at({0.0, 1.7, 6.0});
    const scene::CameraView far = camera_at({5.0, 9.0, 12.0}, 70.0);
    const auto fit = [&](const scene::CameraView& camera) {
        return fit_cascades({camera, court.axes, receivers, {&caster, 1}, {2.0, 32.0}, 3, 512}, {});
    };
    const auto a = fit(near);
    const auto b = fit(far);
    EXPECT_EQ(a.back().min, b.back().min);
    EXPECT_EQ(a.back().texel, b.back().texel);
    EXPECT_TRUE(reaches(a.back(), caster));
    // Where nothing casts no texel is spent.
    EXPECT_LT(a.back().texel.x * 512.0, 6.0);
}

TEST(CascadeFit, ACasterAboveTheMapReachesItAndOneBesideItDoesNot) {
    const Court court;
    const auto views = court.fit(camera_at({0.0, 1.7, 0.0}), {});
    const glm::dvec3 against = -glm::transpose(court.axes)[2];
    const glm::dvec3 above = glm::dvec3(0.0, 0.0, -3.0) + against * 500.0;
    EXPECT_TRUE(reaches(views.front(), {above - 1.0, above + 1.0}));
    const glm::dvec3 beside = above + glm::transpose(court.axes)[0] * 300.0;
    EXPECT_FALSE(reaches(views.front(), {beside - 1.0, beside + 1.0}));
}

TEST(SteadyRange, HoldsWhileItFitsAndMovesInSteps) {
    const DepthRange first = steady_range({3.0, 90.0}, std::nullopt);
    EXPECT_LE(first.near, 3.0);
    EXPECT_GE(first.far, 90.0);
    EXPECT_EQ(steady_range({first.near * 1.5, first.far * 0.8}, first), first);
    const DepthRange nearer = steady_range({first.near * 0.5, first.far}, first);
    EXPECT_LE(nearer.near, first.near * 0.5);
    EXPECT_GT(nearer.near, first.near * 0.25);
}

/// The ranges of frames in which a far thing is there every other time.
std::vector<HeldRange> with_a_bird_that_blinks(const Remedies& remedies) {
    std::vector<HeldRange> frames;
    std::optional<HeldRange> held;
    for (int frame = 0; frame < 3 * kHeldFrames; ++frame) {
        held = held_range({2.0, frame % 2 == 0 ? 90.0 : 30.0}, held, remedies);
        frames.push_back(*held);
    }
    return frames;
}

TEST(HeldRange, StaysWhileSomethingFarComesAndGoes) {
    for (const HeldRange& frame : with_a_bird_that_blinks({}))
        EXPECT_GE(frame.range.far, 90.0);
}

TEST(HeldRange, ChangesInEveryFrameWithoutItsRemedy) {
    const auto frames = with_a_bird_that_blinks(Remedies().without(Remedy::map_held_range));
    for (std::size_t i = 1; i < frames.size(); ++i)
        EXPECT_NE(frames[i].range, frames[i - 1].range) << i;
}

TEST(HeldRange, GrowsAtOnceAndShrinksWhenLessHasDoneForAWhile) {
    std::optional<HeldRange> held = held_range({2.0, 30.0}, std::nullopt, {});
    const DepthRange small = held->range;
    held = held_range({2.0, 90.0}, held, {});
    EXPECT_GE(held->range.far, 90.0);
    for (int frame = 1; frame < kHeldFrames; ++frame)
        held = held_range({2.0, 30.0}, held, {});
    EXPECT_GE(held->range.far, 90.0);
    held = held_range({2.0, 30.0}, held, {});
    EXPECT_EQ(held->range, small);
}

TEST(SplitDepths, GrowByOneFactor) {
    const auto depths = split_depths({1.0, 81.0}, 4);
    ASSERT_EQ(depths.size(), 4U);
    EXPECT_NEAR(depths[0], 3.0, 1e-9);
    EXPECT_NEAR(depths[3], 81.0, 1e-9);
}

/// A high card over a floor.
ParallelView over_card(double soft, const Remedies& remedies) {
    const scene::CameraView camera = camera_at({0.0, 1.7, 0.0});
    const engine::WorldAabb floor{glm::dvec3(-5.0, 0.0, -5.0), glm::dvec3(5.0, 0.1, 5.0)};
    const engine::WorldAabb card{glm::dvec3(-9.0, 50.0, -9.0), glm::dvec3(9.0, 51.0, 9.0)};
    const glm::dmat3 axes = light_axes(glm::dvec3(0.0, -1.0, 0.0), std::nullopt, remedies);
    const CascadeRequest request{camera, axes, floor, {&card, 1}, {4.0, 128.0}, 1, 1024, soft};
    return fit_cascades(request, remedies).front();
}

TEST(SoftCascades, KnowHowHighTheirCastersAre) {
    const auto without = Remedies().without(Remedy::soft_true_heights);

    EXPECT_LT(over_card(0.05, {}).nearest, -51.0);
    EXPECT_GT(over_card(0.05, without).nearest, -1.0);
    EXPECT_GT(over_card(0.0, {}).nearest, -1.0);
}

TEST(SoftCascades, ReachAsFarAsAPenumbraBeyondTheirReceivers) {
    const ParallelView hard = over_card(0.0, {});
    const ParallelView soft = over_card(0.05, {});

    EXPECT_LT(soft.min.x, hard.min.x - 0.05 * 45.0);
    EXPECT_GT((soft.texel * 1024.0).x, (hard.texel * 1024.0).x + 0.1 * 45.0);
}

} // namespace
} // namespace shadows
