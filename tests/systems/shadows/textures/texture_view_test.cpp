#include "systems/shadows/textures/texture_view.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace shadows {
namespace {

std::vector<engine::WorldAabb> some_boxes(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    std::uniform_real_distribution<double> half(0.0, 0.7);
    std::vector<engine::WorldAabb> boxes;
    for (int i = 0; i < 5; ++i)
        boxes.push_back(box_at({place(random), place(random), place(random)}, half(random)));
    return boxes;
}

glm::dvec3 on_texture(const TextureView& view, const glm::dvec3& point) {
    const glm::dvec4 placed = map_from_world(view) * glm::dvec4(point, 1.0);
    return glm::dvec3(placed) / placed.w;
}

/// Every corner lies inside the border, and nearer than what is infinitely far.
void expect_held(const TextureView& view, const std::vector<engine::WorldAabb>& boxes, double rim) {
    for (const engine::WorldAabb& box : boxes)
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 place = on_texture(view, box.corner(i));
            EXPECT_GE(std::min(place.x, place.y), rim - 1e-6);
            EXPECT_LE(std::max(place.x, place.y), 1.0 - rim + 1e-6);
            EXPECT_GT(place.z, 0.0);
            EXPECT_TRUE(holds(view, box.corner(i)));
        }
}

TEST(TextureView, HoldsAllCastersInsideItsBorder) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> way(-1.0F, 1.0F);
    for (int i = 0; i < 200; ++i) {
        const auto boxes = some_boxes(random);
        const glm::vec3 direction(way(random), way(random), way(random));

        const auto of_sun = fit_texture(sun(direction), boxes, {}, 64, 1);
        const auto of_lamp =
            fit_texture(lamp(-8.0 * glm::dvec3(glm::normalize(direction))), boxes, {}, 64, 1);

        ASSERT_TRUE(of_sun);
        expect_held(*of_sun, boxes, 1.0 / 64.0);
        ASSERT_TRUE(of_lamp);
        expect_held(*of_lamp, boxes, 1.0 / 64.0);
    }
}

TEST(TextureView, SpendsNoTexelBesideItsCasters) {
    const std::vector<engine::WorldAabb> boxes = {box_at({0.0, 1.0, 0.0}, 0.5)};

    const auto view = fit_texture(sun(), boxes, {}, 64, 0);

    // Its rows rise by one in four: a square seen turned by 14 degrees.
    EXPECT_NEAR(side_at(*view, {}), 1.0, 0.25);
}

TEST(TextureView, ALampAmidItsCastersHasNone) {
    const std::vector<engine::WorldAabb> around = {
        box_at({-2.0, 0.0, 0.0}, 0.5), box_at({2.0, 0.0, 0.0}, 0.5)};

    const auto refused = fit_texture(lamp({}), around, {}, 64, 1);

    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the lamp is amid the casters");
}

TEST(TextureView, ALampCloseToALargeCasterHasNone) {
    const std::vector<engine::WorldAabb> slab = {{{-5.0, -0.1, -5.0}, {5.0, 0.0, 5.0}}};

    const auto refused = fit_texture(lamp({0.0, 1.0, 0.0}), slab, {}, 64, 1);

    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("82 degrees"));
}

TEST(TextureView, WhatLiesBehindTheCastersKeepsItsDepth) {
    const std::vector<engine::WorldAabb> boxes = {box_at({0.0, 1.0, 0.0}, 0.5)};
    const engine::WorldAabb cellar{{-1.0, -9.0, -1.0}, {1.0, -8.0, 1.0}};

    const auto view = fit_texture(sun(), boxes, cellar, 64, 1);

    EXPECT_GT(on_texture(*view, {0.0, -9.0, 0.0}).z, 0.0);
    EXPECT_LT(on_texture(*view, {0.0, -9.0, 0.0}).z, on_texture(*view, {0.0, 1.0, 0.0}).z);
}

TEST(TextureView, NothingBehindTheLampIsHeld) {
    const std::vector<engine::WorldAabb> boxes = {box_at({0.0, 1.0, 0.0}, 0.5)};

    const auto view = fit_texture(lamp({0.0, 4.0, 0.0}), boxes, {}, 64, 1);

    EXPECT_TRUE(holds(*view, {0.0, 0.0, 0.0}));
    EXPECT_FALSE(holds(*view, {0.0, 5.0, 0.0}));
    EXPECT_EQ(side_at(*view, {0.0, 5.0, 0.0}), 0.0);
}

} // namespace
} // namespace shadows
