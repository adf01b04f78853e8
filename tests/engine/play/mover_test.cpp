// Bodies walk among walls made by hand: nothing is crossed, low things are climbed, edges are
// fallen from.

#include "engine/core/random.hpp"
#include "engine/play/mover.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace play {

namespace {

constexpr double kFrame = 1.0 / 60.0;
constexpr double kLongFrame = 0.25;

/// Walls and slabs, put together from boxes.
class Place {
public:
    Place& box(const glm::dvec3& low, const glm::dvec3& high) {
        const auto corner = [&](int i) {
            return glm::dvec3(
                (i & 1) != 0 ? high.x : low.x,
                (i & 2) != 0 ? high.y : low.y,
                (i & 4) != 0 ? high.z : low.z);
        };
        constexpr std::array<std::array<int, 4>, 6> kSides = {
            {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
        for (const auto& [a, b, c, d] : kSides)
            quad(corner(a), corner(b), corner(c), corner(d));
        return *this;
    }
    Place&
    quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
        triangles_.push_back({a, b, c});
        triangles_.push_back({a, c, d});
        return *this;
    }
    /// A floor of 40 by 40 m at height 0, without thickness.
    Place& floor() { return quad({-20, 0, -20}, {20, 0, -20}, {20, 0, 20}, {-20, 0, 20}); }
    [[nodiscard]] Obstacles made() const { return Obstacles(triangles_); }

private:
    std::vector<Triangle> triangles_;
};

Stance standing(double x, double y, double z) {
    return {.feet = {x, y, z}, .grounded = true};
}

/// Walks for some seconds in frames of the given length.
Stance walk(
    const Obstacles& place,
    Stance stance,
    const glm::dvec2& velocity,
    double seconds,
    double frame = kFrame) {
    for (double time = 0.0; time < seconds - 1e-9; time += frame)
        stance = moved(place, Body(), stance, velocity, frame);
    return stance;
}

TEST(Mover, WalksAsFastAsItIsAsked) {
    const Obstacles place = Place().floor().made();

    const Stance stance = walk(place, standing(0, 0, 0), {3.0, -4.0}, 1.0);

    EXPECT_NEAR(stance.feet.x, 3.0, 1e-9);
    EXPECT_NEAR(stance.feet.z, -4.0, 1e-9);
    EXPECT_NEAR(stance.feet.y, 0.0, 1e-9);
    EXPECT_TRUE(stance.grounded);
}

TEST(Mover, SlidesAlongAWall) {
    const Obstacles place = Place().floor().box({2, 0, -20}, {2.1, 3, 20}).made();

    const Stance stance = walk(place, standing(0, 0, 0), {2.0, 2.0}, 4.0);

    EXPECT_NEAR(stance.feet.x, 2.0 - 0.3, 1e-3);
    EXPECT_NEAR(stance.feet.z, 8.0, 0.01); // the wall takes nothing of the way along it
}

TEST(Mover, SlidesRoundAColumn) {
    const Obstacles place = Place().floor().box({-0.5, 0, -3}, {0.5, 3, -2}).made();

    const Stance stance = walk(place, standing(0.45, 0, 0), {0.3, -2.0}, 4.0);

    EXPECT_LT(stance.feet.z, -3.5);
}

TEST(Mover, ClimbsAStepOfThirtyCentimetres) {
    const Obstacles place = Place().floor().box({1, 0, -5}, {9, 0.3, 5}).made();

    const Stance stance = walk(place, standing(0, 0, 0), {1.5, 0.0}, 2.0);

    EXPECT_NEAR(stance.feet.x, 3.0, 1e-6);
    EXPECT_NEAR(stance.feet.y, 0.3, 1e-6);
}

TEST(Mover, StopsAtAnEdgeOfHalfAMetre) {
    const Obstacles place = Place().floor().box({1, 0, -5}, {9, 0.5, 5}).made();

    const Stance stance = walk(place, standing(0, 0, 0), {1.5, 0.0}, 2.0);

    EXPECT_NEAR(stance.feet.x, 0.7, 1e-3);
    EXPECT_NEAR(stance.feet.y, 0.0, 1e-9);
}

TEST(Mover, GoesUpAndDownStairs) {
    Place stairs = Place().floor();
    for (int i = 0; i < 6; ++i) {
        stairs.box({1.0 + 0.35 * i, 0, -2}, {6.0 - 0.35 * i, 0.2 * (i + 1), 2});
    }
    const Obstacles place = stairs.made();

    const Stance top = walk(place, standing(0, 0, 0), {1.5, 0.0}, 2.3);
    const Stance down = walk(place, top, {1.5, 0.0}, 3.0);

    EXPECT_NEAR(top.feet.y, 1.2, 1e-6);
    EXPECT_NEAR(down.feet.y, 0.0, 1e-6);
    EXPECT_TRUE(down.grounded);
}

TEST(Mover, TheEyeFollowsAStepWithoutAJump) {
    const Obstacles place = Place().floor().box({1, 0, -5}, {9, 0.3, 5}).made();
    Stance stance = standing(0, 0, 0);

    double largest = 0.0;
    for (int i = 0; i < 90; ++i) {
        const Stance next = moved(place, Body(), stance, {1.5, 0.0}, kFrame);
        largest = std::max(largest, std::abs(next.eye(Body()).y - stance.eye(Body()).y));
        stance = next;
    }

    EXPECT_LT(largest, 0.06);
    EXPECT_NEAR(stance.eye(Body()).y, 0.3 + 1.7, 0.01);
}

TEST(Mover, WalksUpAGentleSlopeAndNotUpASteepOne) {
    const auto climb = [](double rise) {
        const Obstacles place =
            Place().floor().quad({1, 0, -5}, {9, 8 * rise, -5}, {9, 8 * rise, 5}, {1, 0, 5}).made();
        return walk(place, standing(0, 0, 0), {1.5, 0.0}, 4.0).feet.y;
    };

    EXPECT_NEAR(climb(0.5), 2.5, 0.01);
    EXPECT_LT(climb(2.0), 0.2);
}

TEST(Mover, FallsOffAnEdgeAndLands) {
    const Obstacles place = Place().floor().box({-5, 0, -5}, {0, 3, 5}).made();

    const Stance falling = walk(place, standing(-0.5, 3, 0), {1.5, 0.0}, 0.7);
    const Stance landed = walk(place, falling, {0.0, 0.0}, 1.5);

    EXPECT_FALSE(falling.grounded);
    EXPECT_TRUE(landed.grounded);
    EXPECT_NEAR(landed.feet.y, 0.0, 1e-6);
    EXPECT_EQ(landed.fall_speed, 0.0);
}

TEST(Mover, FallsThroughNoFloorInLongFrames) {
    const Obstacles place = Place().floor().made();

    const Stance stance = walk(place, {.feet = {0, 200, 0}}, {0.5, 0.0}, 10.0, kLongFrame);

    EXPECT_NEAR(stance.feet.y, 0.0, 1e-6);
    EXPECT_TRUE(stance.grounded);
}

TEST(Mover, CrossesNoThinWallInLongFrames) {
    const Obstacles place =
        Place().floor().quad({2, 0, -9}, {2, 0, 9}, {2, 3, 9}, {2, 3, -9}).made();

    const Stance stance = walk(place, standing(0, 0, 0), {40.0, 0.0}, 2.0, kLongFrame);

    EXPECT_NEAR(stance.feet.x, 1.7, 1e-3);
}

TEST(Mover, StopsInACorner) {
    const Obstacles place =
        Place().floor().box({2, 0, -9}, {3, 3, 9}).box({-9, 0, 2}, {9, 3, 3}).made();

    const Stance stance = walk(place, standing(0, 0, 0), {2.0, 1.5}, 4.0);

    EXPECT_NEAR(stance.feet.x, 1.7, 1e-3);
    EXPECT_NEAR(stance.feet.z, 1.7, 1e-3);
}

TEST(Mover, StopsInAnAcuteCorner) {
    // Two walls that meet at 30 degrees in (4, 0): the disc rests where both are 0.3 m away.
    const double slope = std::tan(std::numbers::pi / 12.0);
    const Obstacles place =
        Place()
            .floor()
            .quad({-4, 0, 8 * slope}, {4, 0, 0}, {4, 3, 0}, {-4, 3, 8 * slope})
            .quad({-4, 0, -8 * slope}, {4, 0, 0}, {4, 3, 0}, {-4, 3, -8 * slope})
            .made();

    for (const double angle : {0.0, 0.2, -0.2}) {
        SCOPED_TRACE(angle);
        const Stance stance =
            walk(place, standing(0, 0, 0), {3.0 * std::cos(angle), 3.0 * std::sin(angle)}, 4.0);
        EXPECT_NEAR(stance.feet.x, 4.0 - 0.3 / std::sin(std::numbers::pi / 12.0), 0.01);
        EXPECT_NEAR(stance.feet.z, 0.0, 0.01);
    }
}

TEST(Mover, EntersNoClosedRoom) {
    const Obstacles place = Place()
                                .floor()
                                .quad({-2, 0, -2}, {2, 0, -2}, {2, 2.5, -2}, {-2, 2.5, -2})
                                .quad({-2, 0, 2}, {2, 0, 2}, {2, 2.5, 2}, {-2, 2.5, 2})
                                .quad({-2, 0, -2}, {-2, 0, 2}, {-2, 2.5, 2}, {-2, 2.5, -2})
                                .quad({2, 0, -2}, {2, 0, 2}, {2, 2.5, 2}, {2, 2.5, -2})
                                .made();
    engine::Random random(7);

    for (int walker = 0; walker < 20; ++walker) {
        SCOPED_TRACE(walker);
        const double side = 2.0 * std::numbers::pi * walker / 20.0;
        Stance stance = standing(5.0 * std::cos(side), 0, 5.0 * std::sin(side));
        for (int i = 0; i < 60; ++i) { // mostly towards the middle, in frames of any length
            const glm::dvec2 wander(random.uniform() - 0.5, random.uniform() - 0.5);
            const glm::dvec2 inwards = -glm::dvec2(stance.feet.x, stance.feet.z);
            const double seconds = kLongFrame * random.uniform();
            stance = moved(place, Body(), stance, inwards + 8.0 * wander, seconds);
            const glm::dvec2 beyond =
                glm::max(glm::abs(glm::dvec2(stance.feet.x, stance.feet.z)) - 2.0, glm::dvec2(0.0));
            ASSERT_GT(glm::length(beyond), 0.3) << i;
        }
    }
}

TEST(Mover, StaysUnderALowCeilingThatRisesWithNoStep) {
    // A step under a beam: the body would hit its head.
    const Obstacles place =
        Place().floor().box({1, 0, -5}, {9, 0.3, 5}).box({1, 2.0, -5}, {9, 2.2, 5}).made();

    const Stance stance = walk(place, standing(0, 0, 0), {1.5, 0.0}, 2.0);

    EXPECT_LT(stance.feet.x, 1.0 + 1e-6);
    EXPECT_NEAR(stance.feet.y, 0.0, 1e-9);
}

TEST(Mover, StandsOnNoGapNarrowerThanItself) {
    const Obstacles place =
        Place().box({-5, 0, -5}, {-0.1, 1, 5}).box({0.1, 0, -5}, {5, 1, 5}).made();

    const Stance stance = walk(place, standing(-2, 1, 0), {1.0, 0.0}, 4.0);

    EXPECT_NEAR(stance.feet.x, 2.0, 0.01);
    EXPECT_NEAR(stance.feet.y, 1.0, 1e-6);
}

TEST(Mover, TheSameArgumentsGiveTheSameStance) {
    const Obstacles place = Place().floor().box({1, 0, -5}, {1.2, 3, 5}).made();

    const Stance first = walk(place, standing(0, 0, 0), {1.0, 0.7}, 3.0, 0.05);
    const Stance second = walk(place, standing(0, 0, 0), {1.0, 0.7}, 3.0, 0.05);

    EXPECT_EQ(first.feet, second.feet);
}

TEST(Mover, WithoutGroundItFallsForEver) {
    const Obstacles place = Place().made();

    const Stance stance = walk(place, {.feet = {0, 0, 0}}, {0.0, 0.0}, 2.0);

    EXPECT_LT(stance.feet.y, -15.0);
    EXPECT_FALSE(stance.grounded);
}

} // namespace

} // namespace play
