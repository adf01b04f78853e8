// Posed meshes in closed form: world_from_local * posed = sum of weight * joint * inverse bind *
// rest.

#include "engine/scene/primitives.hpp"
#include "engine/scene/world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using scene::PosedMesh;
using scene::Transform;

/// A mesh of two triangles, skinned to two joints ("hip" with "knee" under it), with a node of its
/// own.
scene::Model skinned_model() {
    scene::Mesh mesh;
    mesh.name = "leg";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.indices = {0, 1, 2, 1, 3, 2};
    mesh.influences = {
        {{0, 1, 0, 0}, {1, 0, 0, 0}},
        {{0, 1, 0, 0}, {0.5F, 0.5F, 0, 0}},
        {{0, 1, 0, 0}, {0.25F, 0.75F, 0, 0}},
        {{0, 1, 0, 0}, {0, 1, 0, 0}}};
    scene::finish_mesh(mesh);

    scene::Model model;
    model.meshes = {mesh};
    model.materials.resize(1);
    model.nodes.resize(3);
    model.nodes[0].name = "hip";
    model.nodes[1].name = "knee";
    model.nodes[1].parent = 0;
    model.nodes[1].local.position = {0, 1, 0};
    model.nodes[2].name = "mesh";
    model.nodes[2].mesh = 0;
    model.nodes[2].skin = 0;
    glm::mat4 knee_from_mesh(1.0F);
    knee_from_mesh[3] = {0, -1, 0, 1};
    model.skins = {{"skin", {0, 1}, {glm::mat4(1.0F), knee_from_mesh}}};
    return model;
}

struct PosedWorld {
    scene::World world;
    ecs::Entity root;

    explicit PosedWorld(scene::Model&& model) {
        root = scene::instantiate(world, scene::add_assets(world.assets, std::move(model)), "m");
        scene::update(world, 0.0F);
    }

    ecs::Entity named(const std::string& name) {
        for (const ecs::Entity entity : world.registry.view<scene::Name>())
            if (world.registry.get<scene::Name>(entity).text == name) return entity;
        ADD_FAILURE() << name;
        return ecs::kNoEntity;
    }
    const PosedMesh& posed() { return world.registry.get<PosedMesh>(named("m/mesh")); }
    void change(const std::string& name, const Transform& transform) {
        world.registry.patch<Transform>(
            named(name), [&](Transform& changed) { changed = transform; });
        scene::update(world, 0.0F);
    }
    glm::dvec3 in_world(std::size_t vertex) {
        const auto& placed = world.registry.get<scene::WorldTransform>(named("m/mesh"));
        return glm::dvec3(
            placed.world_from_local * glm::dvec4(glm::dvec3(posed().positions[vertex]), 1.0));
    }
};

/// A quarter turn about z: x becomes y.
glm::quat quarter_turn() {
    return {std::sqrt(0.5F), 0, 0, std::sqrt(0.5F)};
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(PoseMeshes, TheBindPoseIsTheMeshItself) {
    PosedWorld posed(skinned_model());

    for (std::size_t i = 0; i < 4; ++i)
        expect_near(posed.in_world(i), glm::dvec3(skinned_model().meshes[0].positions[i]));
}

TEST(PoseMeshes, VerticesFollowTheirJointsByWeight) {
    PosedWorld posed(skinned_model());

    posed.change("m/knee", {{0, 1, 0}, quarter_turn(), {1, 1, 1}});

    expect_near(posed.in_world(0), {0, 0, 0});
    // Joint 1 takes (x, y) to (1 - y, 1 + x): half of (1, 0) and half of (1, 2).
    expect_near(posed.in_world(1), {1, 1, 0});
    expect_near(posed.in_world(2), 0.25 * glm::dvec3(0, 1, 0) + 0.75 * glm::dvec3(0, 1, 0));
    expect_near(posed.in_world(3), {-1, 1, 0});
}

TEST(PoseMeshes, TheMeshNodesOwnTransformDoesNotMatter) {
    PosedWorld posed(skinned_model());
    posed.change("m/knee", {{0, 1, 0}, quarter_turn(), {1, 1, 1}});

    posed.change("m/mesh", {{50, -3, 2}, quarter_turn(), {2, -1, 0.5F}});

    expect_near(posed.in_world(3), {-1, 1, 0}, 1e-5);
    expect_near(posed.in_world(1), {1, 1, 0}, 1e-5);
}

TEST(PoseMeshes, TheWholeInstanceMovesWithItsRoot) {
    PosedWorld posed(skinned_model());

    posed.change("m", {{100'000, 0, 0}, quarter_turn(), {1, 1, 1}});

    expect_near(posed.in_world(3), {100'000 - 2, 0, 0}, 1e-4);
}

TEST(PoseMeshes, AMeshFlattenedByItsNodeStaysFinite) {
    PosedWorld posed(skinned_model());

    posed.change("m/mesh", {{}, {1, 0, 0, 0}, {0, 1, 1}});

    EXPECT_TRUE(std::isfinite(posed.posed().positions[3].x));
}

TEST(PoseMeshes, NormalsStayUnitAndAtRightAnglesUnderStretching) {
    PosedWorld posed(skinned_model());
    const glm::quat tilt = glm::angleAxis(0.5F, glm::vec3(1, 0, 0));

    posed.change("m/hip", {{}, tilt, {1, 5, 0.2F}});

    const glm::vec3 along = posed.posed().positions[3] - posed.posed().positions[0];
    EXPECT_NEAR(glm::length(posed.posed().normals[0]), 1.0F, 1e-5F);
    EXPECT_NEAR(glm::dot(posed.posed().normals[0], along), 0.0F, 1e-4F);
    EXPECT_GT(posed.posed().normals[0].z, 0.0F);
}

TEST(PoseMeshes, NormalsOfMirroredJointsPointOutward) {
    PosedWorld posed(skinned_model());

    posed.change("m/hip", {{}, {1, 0, 0, 0}, {-1, 1, 1}});

    EXPECT_NEAR(posed.posed().normals[0].z, 1.0F, 1e-6F);
}

TEST(PoseMeshes, BoundsAreExact) {
    PosedWorld posed(skinned_model());

    posed.change("m/knee", {{0, 1, 0}, quarter_turn(), {1, 1, 1}});

    expect_near(glm::dvec3(posed.posed().bounds.min), {-1, 0, 0});
    expect_near(glm::dvec3(posed.posed().bounds.max), {1, 1, 0});
    expect_near(scene::world_bounds(posed.world, posed.named("m/mesh")).min, {-1, 0, 0});
}

TEST(PoseMeshes, AStillSceneIsNotPosedAgain) {
    PosedWorld posed(skinned_model());
    const auto version = posed.world.registry.version<PosedMesh>();

    scene::update(posed.world, 0.0F);
    EXPECT_EQ(posed.world.registry.version<PosedMesh>(), version);

    posed.change("m/knee", {{0, 3, 0}});
    EXPECT_GT(posed.world.registry.version<PosedMesh>(), version);
}

scene::Model morphed_model() {
    scene::Model model = skinned_model();
    scene::Mesh& mesh = model.meshes[0];
    mesh.influences.clear();
    mesh.morph_targets = {
        {{{0, 0, 2}, {0, 0, 2}, {0, 0, 2}, {0, 0, 2}}, {}},
        {{{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {0, 0, 0}},
         {{0, 1, -1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
    mesh.morph_weights = {0, 0};
    model.nodes[2].skin.reset();
    model.nodes[2].morph_weights = {0.5F, 0};
    return model;
}

TEST(PoseMeshes, MorphTargetsAddUpByWeight) {
    PosedWorld posed(morphed_model());

    expect_near(posed.in_world(1), {1, 0, 1});
    expect_near(glm::dvec3(posed.posed().bounds.max), {1, 2, 1});

    posed.world.registry.patch<scene::MorphWeights>(
        posed.named("m/mesh"), [](scene::MorphWeights& weights) {
            weights.weights = {0, 1};
        });
    scene::update(posed.world, 0.0F);

    expect_near(posed.in_world(1), {5, 0, 0});
    expect_near(glm::dvec3(posed.posed().normals[0]), {0, 1, 0});
}

TEST(PoseMeshes, ClipsMoveMorphWeights) {
    scene::Model model = morphed_model();
    model.clips = {
        {"grow",
         {{2,
           scene::AnimatedProperty::morph_weights,
           scene::Interpolation::linear,
           {0, 1},
           {0, 0, 1, 1},
           2}},
         1.0F}};
    PosedWorld posed(std::move(model));

    scene::update(posed.world, 0.25F);

    expect_near(posed.in_world(1), {2, 0, 0.5});
}

} // namespace
