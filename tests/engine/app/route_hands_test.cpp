// The person at the keys, and the hands that walk by themselves.

#include "engine/app/first_person.hpp"
#include "engine/app/route_hands.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace app {

namespace {

constexpr double kFrame = 1.0 / 30.0;

/// A floor of 40 by 40 m.
std::vector<play::Triangle> floor() {
    const glm::dvec3 a(-20, 0, -20);
    const glm::dvec3 b(20, 0, -20);
    const glm::dvec3 c(20, 0, 20);
    const glm::dvec3 d(-20, 0, 20);
    return {{a, b, c}, {a, c, d}};
}

scene::PlayerDescription player(float heading = 0.0F) {
    scene::PlayerDescription described;
    described.heading = heading;
    described.speed = 2.0F;
    return described;
}

TEST(FirstPerson, WalksTheWayItLooks) {
    const play::Obstacles obstacles(floor());
    FirstPerson person(player(std::numbers::pi_v<float> / 2.0F)); // looks along -x
    ScriptedInput hands;
    hands.press(Key::w);
    Input input;
    for (int i = 0; i < 30; ++i) {
        input.advance(hands.take());
        person.move(obstacles, input, kFrame);
    }

    EXPECT_NEAR(person.stance().feet.x, -2.0, 1e-5);
    EXPECT_NEAR(person.stance().feet.z, 0.0, 1e-5);
    const scene::CameraView view = person.view({640, 360});
    EXPECT_NEAR(view.position.y, 1.7, 1e-6);
    EXPECT_NEAR(view.world_from_view[2].x, 1.0F, 1e-5F);
}

TEST(FirstPerson, WhoeverFallsOutOfTheLevelBeginsAgain) {
    const play::Obstacles obstacles(floor());
    scene::PlayerDescription described = player();
    described.position = {0.0, 0.0, -19.5};
    FirstPerson person(described);
    ScriptedInput hands;
    hands.press(Key::w);
    Input input;
    double lowest = 0.0;
    for (int i = 0; i < 200 && person.stance().feet.y > -45.0; ++i) {
        input.advance(hands.take());
        person.move(obstacles, input, kFrame);
        lowest = std::min(lowest, person.stance().feet.y);
    }
    input.advance({});
    for (int i = 0; i < 30; ++i)
        person.move(obstacles, input, kFrame);

    EXPECT_LT(lowest, -40.0);
    EXPECT_EQ(person.stance().feet, described.position);
}

TEST(RouteHands, GoRoundAClosedPath) {
    const play::Obstacles obstacles(floor());
    FirstPerson person(player());
    RouteHands hands({"square", {{3, 0, 0}, {3, 0, -3}, {0, 0, -3}, {0, 0, 0}}, true});
    Input input;
    double farthest = 0.0;
    for (double time = 0.0; time < 30.0; time += kFrame) {
        input.advance(hands.take(person, kFrame));
        person.move(obstacles, input, kFrame);
        farthest = std::max(farthest, glm::length(person.stance().feet));
    }

    EXPECT_GE(hands.rounds(), 3);
    EXPECT_EQ(hands.missed(), 0);
    EXPECT_LT(farthest, 6.0);
    EXPECT_GT(farthest, 3.8);
}

TEST(RouteHands, GoToAndFroOnAnOpenPath) {
    const play::Obstacles obstacles(floor());
    FirstPerson person(player());
    RouteHands hands({"line", {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}, false});
    Input input;
    for (double time = 0.0; time < 30.0; time += kFrame) {
        input.advance(hands.take(person, kFrame));
        person.move(obstacles, input, kFrame);
        ASSERT_GT(person.stance().feet.x, -1.0);
        ASSERT_LT(person.stance().feet.x, 5.0);
    }

    EXPECT_GE(hands.rounds(), 3);
    EXPECT_EQ(hands.missed(), 0);
}

TEST(RouteHands, GiveUpAPointBehindAWall) {
    std::vector<play::Triangle> triangles = floor();
    triangles.push_back({{{2, 0, -20}, {2, 0, 20}, {2, 30, 0}}});
    const play::Obstacles obstacles(triangles);
    FirstPerson person(player());
    RouteHands hands({"blocked", {{6, 0, 0}, {0, 0, 0}}, true});
    Input input;
    for (double time = 0.0; time < 20.0; time += kFrame) {
        input.advance(hands.take(person, kFrame));
        person.move(obstacles, input, kFrame);
        ASSERT_LT(person.stance().feet.x, 1.71);
    }

    EXPECT_GE(hands.missed(), 1);
    EXPECT_GE(hands.rounds(), 1);
}

} // namespace

} // namespace app
