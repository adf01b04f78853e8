#include "engine/core/random.hpp"
#include "engine/scene/nearest_triangle.hpp"
#include "engine/scene/primitives.hpp"
#include "engine/scene/proxy.hpp"
#include "tests/support/worlds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scene {
namespace {

using testing::IsEmpty;

/// A knotty solid: its surface bulges, has saddles and ridges.
Mesh knotty_ring() {
    Mesh ring = make_torus(1.0F, 0.35F, 96, 40);
    for (glm::vec3& p : ring.positions) {
        const float angle = std::atan2(p.z, p.x);
        p.y += 0.3F * std::sin(3.0F * angle);
        p *= 1.0F + 0.1F * std::cos(5.0F * angle);
    }
    ring.submeshes.clear();
    finish_mesh(ring);
    return ring;
}

std::vector<std::pair<std::string, Mesh>> meshes() {
    return {{"ball", make_sphere(0.8F, 48)}, {"ring", knotty_ring()}};
}

/// Random points of triangles, as many on each as its share of `count`.
std::vector<glm::dvec3> random_points(
    const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& corners, int count) {
    engine::Random random(5);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < count; ++i) {
        const std::size_t t = static_cast<std::size_t>(i) % (corners.size() / 3);
        double u = random.uniform(0.0, 1.0);
        double v = random.uniform(0.0, 1.0);
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const glm::dvec3 a(positions[corners[3 * t]]);
        points.push_back(
            a + (glm::dvec3(positions[corners[3 * t + 1]]) - a) * u
            + (glm::dvec3(positions[corners[3 * t + 2]]) - a) * v);
    }
    return points;
}

/// Of random points of one surface from the other one.
double most_distant(
    const Mesh& mesh,
    const std::vector<std::uint32_t>& from,
    const std::vector<std::uint32_t>& to) {
    const NearestTriangle surface(mesh.positions, to);
    double most = 0.0;
    for (const glm::dvec3& point : random_points(mesh.positions, from, 200'000))
        most = std::max(most, surface.distance(point));
    return most;
}

TEST(NearestTriangle, IsWhatTryingThemAllFinds) {
    const Mesh ring = knotty_ring();
    const NearestTriangle surface(ring.positions, ring.indices);
    engine::Random random(3);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 p(
            random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
        double least = 1e9;
        for (std::size_t t = 0; t < ring.indices.size(); t += 3)
            least = std::min(
                least,
                glm::length(
                    p
                    - nearest_on_triangle(
                        p,
                        ring.positions[ring.indices[t]],
                        ring.positions[ring.indices[t + 1]],
                        ring.positions[ring.indices[t + 2]])));

        EXPECT_NEAR(surface.distance(p), least, 1e-12);
    }
}

TEST(NearestTriangle, OfAPointBesideATriangleIsOnItsRim) {
    const glm::dvec3 a(0.0);
    const glm::dvec3 b(1.0, 0.0, 0.0);
    const glm::dvec3 c(0.0, 1.0, 0.0);

    EXPECT_EQ(nearest_on_triangle({0.5, -1.0, 2.0}, a, b, c), glm::dvec3(0.5, 0.0, 0.0));
    EXPECT_EQ(nearest_on_triangle({-1.0, -1.0, 0.0}, a, b, c), a);
    EXPECT_EQ(nearest_on_triangle({1.0, 1.0, 3.0}, a, b, c), glm::dvec3(0.5, 0.5, 0.0));
    EXPECT_EQ(nearest_on_triangle({0.25, 0.25, 3.0}, a, b, c), glm::dvec3(0.25, 0.25, 0.0));
}

TEST(Proxy, HasAQuarterOfTheTrianglesOfTheLevelBefore) {
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const std::vector<Proxy> proxies = make_proxies(mesh);

        ASSERT_GE(proxies.size(), 2U);
        double before = mesh.health.triangles;
        for (const Proxy& proxy : proxies) {
            EXPECT_LE(proxy.triangle_count(), 0.26 * before);
            EXPECT_GE(proxy.triangle_count(), 0.24 * before - 2.0);
            before = proxy.triangle_count();
        }
    }
}

TEST(Proxy, IsClosedAndOfTheMeshsOwnVertices) {
    for (const auto& [name, mesh] : meshes())
        for (const Proxy& proxy : make_proxies(mesh)) {
            SCOPED_TRACE(name);
            for (const std::uint32_t corner : proxy.corners)
                ASSERT_LT(corner, mesh.positions.size());
            EXPECT_TRUE(examine_mesh(mesh.positions, proxy.corners).closed());
        }
}

TEST(Proxy, NoPointOfEitherSurfaceIsFartherFromTheOtherThanItsDeviation) {
    for (const auto& [name, mesh] : meshes())
        for (const Proxy& proxy : make_proxies(mesh)) {
            SCOPED_TRACE(name);
            const double measured = std::max(
                most_distant(mesh, mesh.indices, proxy.corners),
                most_distant(mesh, proxy.corners, mesh.indices));

            EXPECT_LE(measured, static_cast<double>(proxy.deviation));
            EXPECT_GE(measured, 0.75 * static_cast<double>(proxy.deviation));
        }
}

TEST(Proxy, IsNotMadeOfWhatDeformsIsOpenOrIsSmall) {
    Mesh bending = make_sphere(0.8F, 24);
    bending.morph_targets.push_back({std::vector<glm::vec3>(bending.positions.size()), {}});
    Mesh open = make_sphere(0.8F, 24);
    open.indices.resize(open.indices.size() - 30);
    open.submeshes.clear();
    finish_mesh(open);

    EXPECT_THAT(make_proxies(bending), IsEmpty());
    EXPECT_THAT(make_proxies(open), IsEmpty());
    EXPECT_THAT(make_proxies(make_box(glm::vec3(1.0F))), IsEmpty());
}

TEST(Proxy, IsMadeOfAMeshWithoutSharedVertices) {
    const Mesh ball = make_sphere(0.8F, 24);
    Mesh soup;
    for (const std::uint32_t index : ball.indices) {
        soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
        soup.positions.push_back(ball.positions[index]);
    }
    soup.normals.assign(soup.positions.size(), {0.0F, 1.0F, 0.0F});
    finish_mesh(soup);

    EXPECT_EQ(make_proxies(soup).size(), make_proxies(ball).size());
}

} // namespace
} // namespace scene
