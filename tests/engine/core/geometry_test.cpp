#include "engine/core/geometry.hpp"
#include "engine/core/random.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace {

using engine::Aabb;
using engine::WorldAabb;

/// Infinite reversed depth: z = near, w = -z_view.
glm::mat4 perspective(float half_width, float half_height, float near_plane) {
    glm::mat4 clip(0.0F);
    clip[0][0] = 1.0F / half_width;
    clip[1][1] = 1.0F / half_height;
    clip[2][3] = -1.0F;
    clip[3][2] = near_plane;
    return clip;
}

Aabb box_at(const glm::vec3& centre, float half) {
    return {centre - glm::vec3(half), centre + glm::vec3(half)};
}

glm::vec3 random_point(engine::Random& random, double half) {
    return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

TEST(Box, TheDefaultIsEmptyAndGrowsToWhatItIsGiven) {
    Aabb box;
    EXPECT_TRUE(box.empty());
    EXPECT_FALSE(box.intersects(box_at({}, 1e6F)));

    box.grow(glm::vec3(1.0F, 2.0F, 3.0F));
    EXPECT_FALSE(box.empty());
    box.grow(glm::vec3(-1.0F, 4.0F, 3.0F));

    EXPECT_EQ(box.centre(), glm::vec3(0.0F, 3.0F, 3.0F));
    EXPECT_EQ(box.extent(), glm::vec3(2.0F, 2.0F, 0.0F));
}

TEST(Box, TouchingIsIntersecting) {
    EXPECT_TRUE(box_at({}, 1.0F).intersects(box_at({2.0F, 0.0F, 0.0F}, 1.0F)));
    EXPECT_FALSE(box_at({}, 1.0F).intersects(box_at({2.01F, 0.0F, 0.0F}, 1.0F)));
}

TEST(Box, CornersTakeEachBitFromItsAxis) {
    const Aabb box = {{0.0F, 0.0F, 0.0F}, {1.0F, 2.0F, 3.0F}};

    EXPECT_EQ(box.corner(0), box.min);
    EXPECT_EQ(box.corner(7), box.max);
    EXPECT_EQ(box.corner(5), glm::vec3(1.0F, 0.0F, 3.0F));
}

TEST(Frustum, KeepsWhatIsInFrontAndDropsWhatIsBehindOnePlane) {
    const engine::Frustum frustum = engine::frustum_from_clip(perspective(1.0F, 1.0F, 0.5F));

    EXPECT_TRUE(frustum.intersects(box_at({0.0F, 0.0F, -10.0F}, 1.0F)));
    EXPECT_TRUE(frustum.intersects(box_at({0.0F, 0.0F, -1e6F}, 1.0F))) << "there is no far plane";
    EXPECT_FALSE(frustum.intersects(box_at({0.0F, 0.0F, 2.0F}, 1.0F)));
    EXPECT_FALSE(frustum.intersects(box_at({0.0F, 0.0F, -0.2F}, 0.1F))) << "before the near plane";
    EXPECT_FALSE(frustum.intersects(box_at({-20.0F, 0.0F, -10.0F}, 1.0F)));
    EXPECT_FALSE(frustum.intersects(box_at({20.0F, 0.0F, -10.0F}, 1.0F)));
    EXPECT_FALSE(frustum.intersects(box_at({0.0F, -20.0F, -10.0F}, 1.0F)));
    EXPECT_FALSE(frustum.intersects(box_at({0.0F, 20.0F, -10.0F}, 1.0F)));
}

TEST(Frustum, PlanesGiveDistancesInTheUnitsOfTheSpace) {
    const engine::Frustum frustum = engine::frustum_from_clip(perspective(1.0F, 1.0F, 0.5F));

    EXPECT_NEAR(frustum.planes[4].distance({0.0F, 0.0F, -3.0F}), 2.5F, 1e-5F);
    EXPECT_NEAR(frustum.planes[0].distance({-3.0F, 0.0F, -3.0F}), 0.0F, 1e-5F);
}

TEST(Frustum, NeverDropsABoxWithAVisiblePoint) {
    const glm::mat4 clip = perspective(0.7F, 0.4F, 0.1F);
    const engine::Frustum frustum = engine::frustum_from_clip(clip);
    engine::Random random(4);
    int visible = 0;
    for (int i = 0; i < 10'000; ++i) {
        const glm::vec3 point = random_point(random, 10.0);
        const glm::vec4 at = clip * glm::vec4(point, 1.0F);
        if (std::abs(at.x) > at.w || std::abs(at.y) > at.w || at.z > at.w) continue;
        ++visible;
        Aabb box = {point, point};
        box.grow(point + random_point(random, 5.0));
        ASSERT_TRUE(frustum.intersects(box));
    }
    EXPECT_GT(visible, 300);
}

TEST(Transformed, HoldsEveryTransformedPointAndTouchesSomeOnEachSide) {
    engine::Random random(5);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        glm::dmat4 matrix(1.0);
        matrix = glm::translate(matrix, glm::dvec3(random_point(random, 1e5)));
        matrix =
            glm::rotate(matrix, random.uniform(0.0, 6.0), glm::dvec3(random_point(random, 1.0)));
        matrix = glm::scale(matrix, glm::dvec3(random_point(random, 3.0)));
        Aabb box;
        box.grow(random_point(random, 2.0));
        box.grow(random_point(random, 2.0));

        const WorldAabb moved = engine::transformed(matrix, box);

        WorldAabb exact;
        for (int corner = 0; corner < 8; ++corner)
            exact.grow(glm::dvec3(matrix * glm::dvec4(box.corner(corner), 1.0)));
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_NEAR(moved.min[axis], exact.min[axis], 1e-5);
            ASSERT_NEAR(moved.max[axis], exact.max[axis], 1e-5);
        }
    }
}

TEST(Transformed, NothingStaysNothing) {
    EXPECT_TRUE(engine::transformed(glm::dmat4(1.0), Aabb{}).empty());
}

TEST(RelativeTo, LosesNothingFarFromTheOrigin) {
    engine::Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 origin = glm::dvec3(random_point(random, 1e5));
        const glm::dvec3 low = origin + glm::dvec3(random_point(random, 300.0));
        const WorldAabb box = {low, low + glm::dvec3(random.uniform(0.0, 10.0))};

        const Aabb relative = engine::relative_to(box, origin);

        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(static_cast<double>(relative.min[axis]), box.min[axis] - origin[axis]);
            ASSERT_GE(static_cast<double>(relative.max[axis]), box.max[axis] - origin[axis]);
            ASSERT_NEAR(
                static_cast<double>(relative.min[axis]), box.min[axis] - origin[axis], 1e-4);
        }
    }
}

TEST(RelativeTo, NothingStaysNothing) {
    EXPECT_TRUE(engine::relative_to(WorldAabb{}, glm::dvec3(1.0)).empty());
}

} // namespace
