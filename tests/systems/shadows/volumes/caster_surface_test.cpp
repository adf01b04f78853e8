#include "engine/scene/primitives.hpp"
#include "systems/shadows/volumes/caster_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace shadows {
namespace {

using testing::Each;

/// Every n-th triangle wound the other way round.
scene::Mesh with_turned(scene::Mesh mesh, std::size_t n) {
    for (std::size_t t = 0; 3 * t < mesh.indices.size(); t += n)
        std::swap(mesh.indices[3 * t], mesh.indices[3 * t + 1]);
    return mesh;
}

scene::Mesh inside_out(const scene::Mesh& mesh) {
    return with_turned(mesh, 1);
}

scene::Mesh quads_round_one_edge(int count) {
    scene::Mesh mesh;
    mesh.positions = {{0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    for (int i = 0; i < count; ++i) {
        const float angle = 0.3F + 6.2831853F * static_cast<float>(i) / static_cast<float>(count);
        const glm::vec3 out(std::cos(angle), 0.0F, std::sin(angle));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(out);
        mesh.positions.push_back(out + glm::vec3(0.0F, 1.0F, 0.0F));
        for (const std::uint32_t index : {0U, first, first + 1, 0U, first + 1, 1U})
            mesh.indices.push_back(index);
    }
    mesh.normals.assign(mesh.positions.size(), {0.0F, 1.0F, 0.0F});
    scene::finish_mesh(mesh);
    return mesh;
}

TEST(CasterSurface, OfABoxIsClosedAlthoughItsFacesShareNoVertex) {
    const CasterSurface box = make_caster_surface(scene::make_box(glm::vec3(1.0F)));

    EXPECT_EQ(box.triangle_count(), 12U);
    EXPECT_EQ(box.edges.size(), 18U);
    EXPECT_THAT(box.dark_weight, Each(0));
    EXPECT_THAT(box.turned, Each(0));
}

TEST(CasterSurface, TurnsTrianglesThatNeighboursSeeWoundTheOtherWayRound) {
    const scene::Mesh ball = scene::make_sphere(1.0F, 12);
    const CasterSurface surface = make_caster_surface(with_turned(ball, 10));

    EXPECT_THAT(surface.dark_weight, Each(0));
    for (std::size_t t = 0; t < surface.turned.size(); ++t)
        EXPECT_EQ(surface.turned[t], t % 10 == 0 ? 1 : 0) << t;
}

TEST(CasterSurface, TurnsAMeshThatIsInsideOut) {
    const CasterSurface surface = make_caster_surface(inside_out(scene::make_sphere(1.0F, 12)));

    EXPECT_THAT(surface.dark_weight, Each(0));
    EXPECT_THAT(surface.turned, Each(1));
}

TEST(CasterSurface, AnOpenMeshBlocksTriangleByTriangle) {
    const CasterSurface plane = make_caster_surface(scene::make_plane({2.0F, 2.0F}));

    EXPECT_THAT(plane.dark_weight, Each(-1));
    EXPECT_EQ(plane.edges.size(), 5U);
}

TEST(CasterSurface, AnEdgeOfThreeSheetsIsAPairAndARest) {
    const CasterSurface fan = make_caster_surface(quads_round_one_edge(3));

    const auto shared = std::count_if(fan.edges.begin(), fan.edges.end(), [](const auto& edge) {
        return edge.from == 0 && edge.to == 1;
    });
    EXPECT_GE(shared, 2);
    EXPECT_LE(shared, 3);
    EXPECT_THAT(fan.dark_weight, Each(-1));
}

TEST(CasterSurface, LeavesOutTrianglesWithoutThreeCorners) {
    scene::Mesh box = scene::make_box(glm::vec3(1.0F));
    for (const std::uint32_t index : {0U, 0U, 1U, 2U, 3U, 3U})
        box.indices.push_back(index);
    box.submeshes[0].index_count += 6;

    const CasterSurface surface = make_caster_surface(box);

    EXPECT_EQ(surface.triangle_count(), 12U);
    EXPECT_THAT(surface.dark_weight, Each(0));
}

TEST(CasterSurface, KeepsVerticesApartThatMoveApart) {
    scene::Mesh box = scene::make_box(glm::vec3(1.0F));
    box.influences.resize(box.positions.size());
    box.influences[0].joints[0] = 1;

    const CasterSurface surface = make_caster_surface(box);

    EXPECT_THAT(surface.dark_weight, Each(-1));
}

TEST(CasterSurface, CountsLayersOfNestedShells) {
    const scene::Mesh ball = scene::make_sphere(1.0F, 24);
    const scene::Mesh torus = scene::make_torus(1.0F, 0.2F);

    EXPECT_EQ(count_layers(make_caster_surface(ball), ball.positions), 4);
    EXPECT_EQ(count_layers(make_caster_surface(torus), torus.positions), 8);
}

} // namespace
} // namespace shadows
