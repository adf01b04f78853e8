// Transforms and the matrices they are taken from.

#include "engine/core/random.hpp"
#include "engine/scene/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

scene::Transform any_transform(engine::Random& random, double lowest_scale) {
    const auto number = [&] { return static_cast<float>(random.uniform(-1, 1)); };
    scene::Transform transform;
    transform.position = {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    transform.rotation = glm::normalize(glm::quat(number(), number(), number(), number()));
    for (int axis = 0; axis < 3; ++axis)
        transform.scale[axis] = static_cast<float>(random.uniform(lowest_scale, 3.0));
    return transform;
}

double largest_difference(const glm::dmat4& a, const glm::dmat4& b) {
    double largest = 0.0;
    for (int column = 0; column < 4; ++column)
        largest = std::max(largest, glm::length(a[column] - b[column]));
    return largest;
}

TEST(Transform, MatrixScalesThenTurnsThenMoves) {
    const float half = std::sqrt(0.5F);
    const scene::Transform transform{
        {10.0, 0.0, 0.0}, {half, 0.0F, 0.0F, half}, {2.0F, 3.0F, 4.0F}}; // 90 degrees about z

    const glm::dvec4 moved = transform.matrix() * glm::dvec4(1.0, 1.0, 1.0, 1.0);

    EXPECT_NEAR(moved.x, 10.0 - 3.0, 1e-6);
    EXPECT_NEAR(moved.y, 2.0, 1e-6);
    EXPECT_NEAR(moved.z, 4.0, 1e-6);
}

TEST(Decompose, GivesTheMatrixBackWhateverItsSigns) {
    engine::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const glm::dmat4 matrix = any_transform(random, -3.0).matrix();

        const scene::Decomposition parts = scene::decompose(matrix);

        EXPECT_LT(parts.shear, 1e-5);
        EXPECT_LT(largest_difference(parts.transform.matrix(), matrix), 1e-5);
    }
}

TEST(Decompose, ColumnsWithoutLengthBecomeScalesOfZero) {
    for (const glm::vec3 scale :
         {glm::vec3(0, 1, 2), glm::vec3(3, 0, 0), glm::vec3(0, 0, -2), glm::vec3(0)}) {
        SCOPED_TRACE(testing::Message() << scale.x << " " << scale.y << " " << scale.z);
        engine::Random random(4);
        scene::Transform transform = any_transform(random, 1.0);
        transform.scale = scale;

        const scene::Decomposition parts = scene::decompose(transform.matrix());

        EXPECT_LT(largest_difference(parts.transform.matrix(), transform.matrix()), 1e-5);
        EXPECT_NEAR(glm::length(parts.transform.rotation), 1.0F, 1e-5F);
    }
}

TEST(Decompose, ReportsShear) {
    glm::dmat4 sheared(1.0);
    sheared[1] = {0.5, 1.0, 0.0, 0.0};

    EXPECT_NEAR(scene::decompose(sheared).shear, 0.5 / std::sqrt(1.25), 1e-6);
}

TEST(Decompose, CollinearColumnsStayFinite) {
    glm::dmat4 flat(1.0);
    flat[1] = flat[0];

    const scene::Transform transform = scene::decompose(flat).transform;

    EXPECT_NEAR(glm::length(transform.rotation), 1.0F, 1e-5F);
    EXPECT_NEAR(transform.scale.y, 0.0F, 1e-6F);
}

} // namespace
