#include "systems/shadows/planar_rectangle.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gtest/gtest.h>

namespace shadows {
namespace {

LitPlane plane_with(const glm::dvec3& normal, double offset) {
    LitPlane plane;
    plane.normal = glm::normalize(normal);
    plane.offset = offset;
    return plane;
}

TEST(PlaneRectangle, HoldsAFloorsBoundsWithALittleRoom) {
    const PlaneRectangle found =
        plane_rectangle(plane_with({0.0, 1.0, 0.0}, 2.0), {{-1.0, 2.0, -3.0}, {3.0, 2.0, 5.0}});

    EXPECT_NEAR(found.size.x, 4.0, 0.4);
    EXPECT_NEAR(found.size.y, 8.0, 0.8);
    EXPECT_GT(found.size.x, 4.0);
    for (const glm::dvec3& corner : {glm::dvec3(-1.0, 2.0, -3.0), glm::dvec3(3.0, 2.0, 5.0)}) {
        const glm::dvec2 place = found.place(corner);
        EXPECT_GT(std::min(place.x, place.y), 0.0);
        EXPECT_LT(std::max(place.x, place.y), 1.0);
    }
}

TEST(PlaneRectangle, SeesThePlaneFromItsLitSide) {
    for (const glm::dvec3& normal :
         {glm::dvec3(0.0, 1.0, 0.0),
          glm::dvec3(0.0, -1.0, 0.0),
          glm::dvec3(1.0, 0.2, 0.0),
          glm::dvec3(0.3, -0.4, 0.8)}) {
        const LitPlane plane = plane_with(normal, 0.5);
        const PlaneRectangle found = plane_rectangle(plane, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}});
        EXPECT_NEAR(glm::dot(glm::cross(found.right, found.up), plane.normal), 1.0, 1e-12);
        EXPECT_NEAR(plane.height(found.corner), 0.0, 1e-12);
    }
}

TEST(PlaneRectangle, FillsItsTexture) {
    const LitPlane plane = plane_with({0.2, 1.0, -0.1}, 1.0);
    const PlaneRectangle found = plane_rectangle(plane, {{0.0, 0.5, 0.0}, {2.0, 1.5, 1.0}});
    const glm::dvec3 origin(5.0, 2.0, -3.0);
    const glm::dmat4 texture = texture_from_plane(found, origin);
    const auto place = [&](const glm::dvec3& point) {
        const glm::dvec4 clip = texture * glm::dvec4(point - origin, 1.0);
        return glm::dvec2(clip) / clip.w;
    };

    EXPECT_NEAR(glm::length(place(found.corner) - glm::dvec2(-1.0)), 0.0, 1e-12);
    const glm::dvec3 far = found.corner + found.right * found.size.x + found.up * found.size.y;
    EXPECT_NEAR(glm::length(place(far) - glm::dvec2(1.0)), 0.0, 1e-12);
}

TEST(PlaneRectangle, HasAsManyTexelsAsAreWanted) {
    PlaneRectangle rectangle;
    rectangle.size = {4.0, 1.0};

    const glm::ivec2 size = kept_size(rectangle, 0.02);

    EXPECT_EQ(size, glm::ivec2(256, 64));
    EXPECT_LE(texel_of(rectangle, size), 0.02);
    EXPECT_EQ(kept_size(rectangle, 1e-9), glm::ivec2(kLargestKept));
    EXPECT_EQ(kept_size(rectangle, 1e9), glm::ivec2(kSmallestKept));
}

} // namespace
} // namespace shadows
