// Every pixel against a tracer that has no tree, no floats and another test for triangles.

#include "engine/core/random.hpp"
#include "engine/trace/visibility.hpp"
#include "tests/engine/trace/small_world.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>

namespace trace {
namespace {

struct PlainTriangle {
    ecs::Entity entity;
    std::uint32_t first_index = 0;
    std::array<glm::dvec3, 3> corners;
    bool mirrored = false;
    bool double_sided = false;
    bool casts = true;
};

std::vector<PlainTriangle> plain_triangles(const scene::World& world) {
    std::vector<PlainTriangle> out;
    world.registry.each<scene::MeshInstance, scene::WorldTransform, scene::ShadowRole>(
        [&](ecs::Entity entity, const auto& instance, const auto& transform, const auto& role) {
            const scene::Mesh& mesh = world.assets.meshes[instance.mesh];
            const scene::Material& material = world.assets.materials[mesh.submeshes[0].material];
            for (std::uint32_t i = 0; i < mesh.indices.size(); i += 3) {
                PlainTriangle triangle = {
                    entity, i, {}, transform.mirrored(), material.double_sided, role.casts};
                for (std::uint32_t k = 0; k < 3; ++k)
                    triangle.corners[k] =
                        transform.world_from_local
                        * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0);
                out.push_back(triangle);
            }
        });
    return out;
}

/// Signed volumes over the three edges have one sign; then the plane gives t.
std::optional<double>
crossing(const PlainTriangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 a = triangle.corners[0] - origin;
    const glm::dvec3 b = triangle.corners[1] - origin;
    const glm::dvec3 c = triangle.corners[2] - origin;
    const double w_a = glm::dot(direction, glm::cross(b, c));
    const double w_b = glm::dot(direction, glm::cross(c, a));
    const double w_c = glm::dot(direction, glm::cross(a, b));
    const bool all_positive = w_a >= 0.0 && w_b >= 0.0 && w_c >= 0.0;
    const bool all_negative = w_a <= 0.0 && w_b <= 0.0 && w_c <= 0.0;
    if (!all_positive && !all_negative) return std::nullopt;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double facing = glm::dot(normal, direction);
    if (facing == 0.0) return std::nullopt;
    return glm::dot(normal, a) / facing;
}

glm::dvec3 normal_of(const PlainTriangle& triangle) {
    const glm::dvec3 normal = glm::normalize(glm::cross(
        triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]));
    return triangle.mirrored ? -normal : normal;
}

/// Boxes, spheres and loose triangles, turned, stretched and mirrored; some single-sided, some that
/// cast nothing.
SmallWorld random_scene(std::uint64_t seed, const glm::dvec3& centre) {
    SmallWorld small;
    engine::Random random(seed);
    small.world.assets.materials.emplace_back().double_sided = true;
    scene::Mesh soup;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 at(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
        for (int k = 0; k < 3; ++k) {
            soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
            soup.positions.push_back(
                at
                + glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
            soup.normals.emplace_back(0, 1, 0);
        }
    }
    soup.submeshes.push_back({scene::Topology::triangles, 0, 900, 1});
    scene::finish_mesh(soup);
    const std::array<std::uint32_t, 3> meshes = {
        small.add_mesh(std::move(soup)),
        small.add_mesh(scene::make_box({1, 2, 1})),
        small.add_mesh(scene::make_sphere(1.0F, 12))};
    small.add(meshes[0], SmallWorld::moved(centre));
    for (int i = 0; i < 8; ++i) {
        glm::dmat4 place = SmallWorld::moved(
            centre
            + glm::dvec3(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)));
        place = glm::rotate(
            place,
            random.uniform(0, 6),
            glm::dvec3(random.uniform(), random.uniform(), 0.1 + random.uniform()));
        place = glm::scale(
            place,
            glm::dvec3(
                random.uniform(0.5, 2),
                random.uniform(0.5, 2),
                (i % 3 == 0 ? -1 : 1) * random.uniform(0.5, 2)));
        const ecs::Entity entity = small.add(meshes[1 + random.below(2)], place);
        small.world.registry.patch<scene::ShadowRole>(
            entity, [i](scene::ShadowRole& role) { role.casts = i != 5; });
    }
    return small;
}

struct PlainPixel {
    const PlainTriangle* triangle = nullptr;
    double t = kInfinity;
    double visibility = 1.0;
};

PlainPixel plain_pixel(
    const std::vector<PlainTriangle>& triangles,
    const scene::CameraView& camera,
    const scene::PlacedLight& light,
    int x,
    int y,
    double offset) {
    PlainPixel pixel;
    const glm::dvec3 direction = camera.ray_direction(x + 0.5, y + 0.5);
    for (const PlainTriangle& triangle : triangles) {
        const auto t = crossing(triangle, camera.position, direction);
        if (!t || *t < static_cast<double>(camera.near) || *t >= pixel.t) continue;
        if (!triangle.double_sided && glm::dot(normal_of(triangle), direction) > 0.0) continue;
        pixel.t = *t;
        pixel.triangle = &triangle;
    }
    if (pixel.triangle == nullptr) return pixel;
    glm::dvec3 normal = normal_of(*pixel.triangle);
    if (glm::dot(normal, direction) > 0.0) normal = -normal;
    const glm::dvec3 position = camera.position + pixel.t * direction;
    const bool sun = light.light.kind == scene::LightKind::directional;
    const glm::dvec3 to_light = sun ? -glm::dvec3(light.direction) : light.position - position;
    if (glm::dot(normal, to_light) <= 0.0) {
        pixel.visibility = 0.0;
        return pixel;
    }
    for (const PlainTriangle& triangle : triangles) {
        if (!triangle.casts || &triangle == pixel.triangle) continue;
        const auto t = crossing(triangle, position + offset * normal, to_light);
        if (t && *t >= 0.0 && (sun || *t < 1.0)) pixel.visibility = 0.0;
    }
    return pixel;
}

void expect_same_everywhere(std::uint64_t seed, const glm::dvec3& centre) {
    const SmallWorld small = random_scene(seed, centre);
    const TraceScene scene(small.world);
    const std::vector<PlainTriangle> triangles = plain_triangles(small.world);
    ASSERT_LE(triangles.size(), 2000U);
    const scene::CameraView camera = camera_at(centre + glm::dvec3(3, 6, 12), centre, 64, 48);
    for (const scene::PlacedLight& light :
         {sun_along({-0.3, -1, 0.4}), lamp_at(centre + glm::dvec3(0.5, 2.5, 3))}) {
        SCOPED_TRACE(light.name);
        const VisibilityImage image = trace_visibility(scene, camera, light);
        int dark = 0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const PlainPixel plain =
                    plain_pixel(triangles, camera, light, x, y, scene.default_offset());
                const auto hit = trace_pixel(scene, camera, light, {x + 0.5, y + 0.5}, {}).hit;
                ASSERT_EQ(hit.has_value(), plain.triangle != nullptr) << x << ", " << y;
                ASSERT_EQ(image.visibility[image.index(x, y)], plain.visibility) << x << ", " << y;
                if (!hit) continue;
                ASSERT_EQ(hit->entity, plain.triangle->entity) << x << ", " << y;
                ASSERT_EQ(hit->triangle, plain.triangle->first_index) << x << ", " << y;
                ASSERT_NEAR(hit->t, plain.t, 1e-9 * plain.t) << x << ", " << y;
                if (plain.visibility == 0.0) ++dark;
            }
        EXPECT_GT(dark, 100);
    }
}

class BruteForce : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BruteForce, AgreesWithTheTreeOnEveryPixel) {
    expect_same_everywhere(GetParam(), {});
}

TEST_P(BruteForce, AgreesWithTheTreeAHundredKilometresAway) {
    expect_same_everywhere(GetParam(), {1e5, 300.0, -1e5});
}

INSTANTIATE_TEST_SUITE_P(Seeds, BruteForce, testing::Values(1, 2, 3));

} // namespace
} // namespace trace
