// Worlds: instances of models, placing, and versions that rise only when something changed.

#include "engine/scene/primitives.hpp"
#include "engine/scene/world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using scene::Parent;
using scene::Transform;
using scene::WorldTransform;

ecs::Entity
add(scene::World& world, const glm::dvec3& position, ecs::Entity parent = ecs::kNoEntity) {
    const ecs::Entity entity = world.registry.create();
    world.registry.add(entity, Transform{position});
    if (parent != ecs::kNoEntity) world.registry.add(entity, Parent{parent});
    return entity;
}

glm::dvec3 place(const scene::World& world, ecs::Entity entity) {
    return glm::dvec3(world.registry.get<WorldTransform>(entity).world_from_local[3]);
}

void move(scene::World& world, ecs::Entity entity, const glm::dvec3& position) {
    world.registry.patch<Transform>(
        entity, [&](Transform& transform) { transform.position = position; });
}

TEST(UpdateWorldTransforms, ChildrenFollowTheirParentsWhateverTheOrderOfMaking) {
    scene::World world;
    const ecs::Entity child = add(world, {1, 0, 0});
    const ecs::Entity parent = add(world, {0, 10, 0});
    const ecs::Entity grandparent = add(world, {0, 0, 100});
    world.registry.add(child, Parent{parent});
    world.registry.add(parent, Parent{grandparent});

    scene::update_world_transforms(world);

    EXPECT_EQ(place(world, child), glm::dvec3(1, 10, 100));
    EXPECT_EQ(place(world, parent), glm::dvec3(0, 10, 100));
}

TEST(UpdateWorldTransforms, PatchesNothingWhenNothingChanged) {
    scene::World world;
    add(world, {0, 2, 0}, add(world, {1, 0, 0}));
    scene::update_world_transforms(world);
    const auto version = world.registry.version<WorldTransform>();

    scene::update_world_transforms(world);

    EXPECT_EQ(world.registry.version<WorldTransform>(), version);
}

TEST(UpdateWorldTransforms, PatchesOnlyWhatMoved) {
    scene::World world;
    const ecs::Entity still = add(world, {5, 0, 0});
    const ecs::Entity parent = add(world, {1, 0, 0});
    const ecs::Entity child = add(world, {0, 2, 0}, parent);
    scene::update_world_transforms(world);
    const auto before = world.registry.version<WorldTransform>(still);

    move(world, parent, {7, 0, 0});
    scene::update_world_transforms(world);

    EXPECT_EQ(place(world, child), glm::dvec3(7, 2, 0));
    EXPECT_EQ(world.registry.version<WorldTransform>(still), before);
}

TEST(UpdateWorldTransforms, APatchThatChangesNothingStopsThere) {
    scene::World world;
    const ecs::Entity entity = add(world, {1, 0, 0});
    scene::update_world_transforms(world);
    const auto version = world.registry.version<WorldTransform>();

    move(world, entity, {1, 0, 0});
    scene::update_world_transforms(world);

    EXPECT_EQ(world.registry.version<WorldTransform>(), version);
}

TEST(UpdateWorldTransforms, NewParentsCount) {
    scene::World world;
    const ecs::Entity a = add(world, {1, 0, 0});
    const ecs::Entity b = add(world, {2, 0, 0});
    const ecs::Entity child = add(world, {0, 1, 0}, a);
    scene::update_world_transforms(world);

    world.registry.patch<Parent>(child, [&](Parent& parent) { parent.entity = b; });
    scene::update_world_transforms(world);

    EXPECT_EQ(place(world, child), glm::dvec3(2, 1, 0));
}

TEST(UpdateWorldTransforms, ADeadParentCountsAsNone) {
    scene::World world;
    const ecs::Entity parent = add(world, {1, 0, 0});
    const ecs::Entity child = add(world, {0, 1, 0}, parent);
    scene::update_world_transforms(world);

    world.registry.destroy(parent);
    scene::update_world_transforms(world);

    EXPECT_EQ(place(world, child), glm::dvec3(0, 1, 0));
}

TEST(UpdateWorldTransforms, AnEntityThatLosesItsTransformStaysWhereItWas) {
    scene::World world;
    const ecs::Entity entity = add(world, {1, 0, 0});
    const ecs::Entity child = add(world, {0, 1, 0}, entity);
    scene::update_world_transforms(world);

    world.registry.remove<Transform>(entity);
    scene::update_world_transforms(world);

    EXPECT_EQ(place(world, entity), glm::dvec3(1, 0, 0));
    EXPECT_EQ(place(world, child), glm::dvec3(0, 1, 0));
}

TEST(UpdateWorldTransforms, EntitiesMadeAfterDeathsArePlaced) {
    scene::World world;
    world.registry.destroy(add(world, {1, 0, 0}));
    scene::update_world_transforms(world);
    const ecs::Entity first = add(world, {2, 0, 0});
    scene::update_world_transforms(world);
    world.registry.destroy(first);
    const ecs::Entity second = add(world, {3, 0, 0});

    scene::update_world_transforms(world);

    EXPECT_EQ(place(world, second), glm::dvec3(3, 0, 0));
}

TEST(UpdateWorldTransforms, MillimetresSurviveFarFromTheOrigin) {
    scene::World world;
    const ecs::Entity child = add(world, {0.001, 0, 0}, add(world, {100'000, 0, 0}));

    scene::update_world_transforms(world);

    EXPECT_NEAR(place(world, child).x, 100'000.001, 1e-9);
}

TEST(UpdateWorldTransformsDeathTest, AnEntityMayNotBeItsOwnAncestor) {
    scene::World world;
    const ecs::Entity a = add(world, {});
    const ecs::Entity b = add(world, {}, a);
    world.registry.add(a, Parent{b});

    EXPECT_DEATH(scene::update_world_transforms(world), "CHECK");
}

/// A box under a node, with a camera, a light and a clip that moves the node.
scene::Model model() {
    scene::Model model;
    model.file = "box.glb";
    model.meshes = {scene::make_box({2, 2, 2})};
    model.materials = {{.name = "white"}};
    model.nodes.resize(2);
    model.nodes[0].name = "base";
    model.nodes[0].local.position = {1, 0, 0};
    model.nodes[0].light = 0;
    model.nodes[0].camera = 0;
    model.nodes[1].name = "box";
    model.nodes[1].parent = 0;
    model.nodes[1].mesh = 0;
    model.cameras.resize(1);
    model.lights.resize(1);
    model.clips = {
        {"slide",
         {{0,
           scene::AnimatedProperty::translation,
           scene::Interpolation::linear,
           {0, 2},
           {1, 0, 0, 5, 0, 0},
           3}},
         2.0F}};
    return model;
}

ecs::Entity named(const scene::World& world, const std::string& name) {
    for (const ecs::Entity entity : world.registry.view<scene::Name>())
        if (world.registry.get<scene::Name>(entity).text == name) return entity;
    ADD_FAILURE() << "nobody is called " << name;
    return ecs::kNoEntity;
}

TEST(Instantiate, MakesOneEntityPerNodeUnderARoot) {
    scene::World world;
    const auto assets = scene::add_assets(world.assets, model());

    const ecs::Entity root = scene::instantiate(world, assets, "crate");
    scene::update(world, 0.0F);

    const ecs::Entity base = named(world, "crate/base");
    const ecs::Entity box = named(world, "crate/box");
    EXPECT_EQ(world.registry.get<scene::Name>(root).text, "crate");
    EXPECT_EQ(world.registry.get<Parent>(base).entity, root);
    EXPECT_EQ(world.registry.get<Parent>(box).entity, base);
    EXPECT_TRUE(world.registry.has<scene::Light>(base));
    EXPECT_TRUE(world.registry.has<scene::Camera>(base));
    EXPECT_TRUE(world.registry.has<scene::ShadowRole>(box));
    EXPECT_FALSE(world.registry.has<scene::PosedMesh>(box));
    EXPECT_EQ(place(world, box), glm::dvec3(1, 0, 0));
}

TEST(Instantiate, WithoutANameNodesKeepTheirOwn) {
    scene::World world;
    scene::instantiate(world, scene::add_assets(world.assets, model()), "");

    named(world, "base");
    named(world, "box");
}

TEST(AddAssets, IndicesMeanTheSameInTheSharedArrays) {
    scene::World world;
    scene::add_assets(world.assets, model());
    scene::Model textured = model();
    textured.textures.resize(1);
    textured.materials[0].texture = 0;
    textured.materials[0].name = "second";

    const auto assets = scene::add_assets(world.assets, std::move(textured));
    scene::instantiate(world, assets, "two");

    const auto& instance = world.registry.get<scene::MeshInstance>(named(world, "two/box"));
    EXPECT_EQ(instance.mesh, 1U);
    const auto material = world.assets.meshes[instance.mesh].submeshes[0].material;
    EXPECT_EQ(world.assets.materials[material].name, "second");
    EXPECT_EQ(assets.first_clip, 1U);
    EXPECT_EQ(assets.clip_count, 1U);
}

TEST(WorldBounds, AreThoseOfPlacedMeshes) {
    scene::World world;
    const auto assets = scene::add_assets(world.assets, model());
    scene::instantiate(world, assets, "a");
    const ecs::Entity second = scene::instantiate(world, assets, "b");
    move(world, second, {10, 0, 0});
    scene::update(world, 0.0F);

    EXPECT_EQ(scene::world_bounds(world, named(world, "b/box")).min, glm::dvec3(10, -1, -1));
    EXPECT_EQ(scene::world_bounds(world).min, glm::dvec3(0, -1, -1));
    EXPECT_EQ(scene::world_bounds(world).max, glm::dvec3(12, 1, 1));
    EXPECT_TRUE(scene::world_bounds(world, second).empty());
}

struct PlayedWorld {
    scene::World world;
    ecs::Entity root;

    PlayedWorld() {
        root = scene::instantiate(world, scene::add_assets(world.assets, model()), "m");
    }

    double x() { return place(world, named(world, "m/box")).x; }
    void set(float speed, bool loops) {
        world.registry.patch<scene::AnimationPlayer>(root, [&](scene::AnimationPlayer& player) {
            player.speed = speed;
            player.loops = loops;
        });
    }
};

TEST(AdvanceAnimations, MovesNodesWithTime) {
    PlayedWorld played;

    scene::update(played.world, 0.5F);

    EXPECT_NEAR(played.x(), 2.0, 1e-6);
}

TEST(AdvanceAnimations, LoopsOrStopsAtTheEnd) {
    PlayedWorld looping;
    PlayedWorld stopping;
    stopping.set(1.0F, false);

    scene::update(looping.world, 2.5F);
    scene::update(stopping.world, 2.5F);

    EXPECT_NEAR(looping.x(), 2.0, 1e-6);
    EXPECT_NEAR(stopping.x(), 5.0, 1e-6);
}

TEST(AdvanceAnimations, NegativeSpeedsRunBackwards) {
    PlayedWorld played;
    played.set(-1.0F, true);

    scene::update(played.world, 0.5F);

    EXPECT_NEAR(played.x(), 4.0, 1e-6);
}

TEST(AdvanceAnimations, StandingStillBumpsNoVersion) {
    PlayedWorld played;
    scene::update(played.world, 0.5F);
    const auto transforms = played.world.registry.version<Transform>();
    const auto worlds = played.world.registry.version<WorldTransform>();
    const auto players = played.world.registry.version<scene::AnimationPlayer>();

    scene::update(played.world, 0.0F);

    EXPECT_EQ(played.world.registry.version<Transform>(), transforms);
    EXPECT_EQ(played.world.registry.version<WorldTransform>(), worlds);
    EXPECT_EQ(played.world.registry.version<scene::AnimationPlayer>(), players);
}

} // namespace
