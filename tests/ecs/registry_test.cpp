// What the registry promises, one behaviour at a time.

#include "ecs/registry.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace {

struct Position {
    float x = 0.0F;
};
struct Label {
    std::string text;
};
struct Tag {};
struct Owner {
    std::unique_ptr<int> value;
};

std::vector<ecs::Entity> make(ecs::Registry& registry, int count) {
    std::vector<ecs::Entity> entities;
    for (int i = 0; i < count; ++i) {
        entities.push_back(registry.create());
        registry.add<Position>(entities.back(), {static_cast<float>(i)});
    }
    return entities;
}

TEST(Registry, GivesBackWhatWasAdded) {
    ecs::Registry registry;
    const ecs::Entity entity = registry.create();

    registry.add<Label>(entity, {"lamp"});

    EXPECT_EQ(registry.get<Label>(entity).text, "lamp");
    EXPECT_TRUE(registry.has<Label>(entity));
    EXPECT_FALSE(registry.has<Position>(entity));
    EXPECT_EQ(registry.try_get<Position>(entity), nullptr);
}

TEST(Registry, HoldsComponentsThatOnlyMove) {
    ecs::Registry registry;
    const ecs::Entity entity = registry.create();

    registry.add(entity, Owner{std::make_unique<int>(7)});
    registry.add<Owner>(registry.create());
    registry.remove<Owner>(entity);

    EXPECT_EQ(registry.count<Owner>(), 1U);
}

TEST(Registry, PatchChangesTheValueAndOnlyItsOwnVersion) {
    ecs::Registry registry;
    const std::vector<ecs::Entity> entities = make(registry, 2);
    const std::uint64_t first = registry.version<Position>(entities[0]);
    const std::uint64_t second = registry.version<Position>(entities[1]);

    registry.patch<Position>(entities[0], [](Position& position) { position.x = 9.0F; });

    EXPECT_EQ(registry.get<Position>(entities[0]).x, 9.0F);
    EXPECT_GT(registry.version<Position>(entities[0]), first);
    EXPECT_EQ(registry.version<Position>(entities[1]), second);
}

TEST(Registry, RemovingAndAddingAgainIsSeenInTheVersion) {
    ecs::Registry registry;
    const ecs::Entity entity = make(registry, 1).front();
    const std::uint64_t before = registry.version<Position>(entity);

    registry.remove<Position>(entity);
    const std::uint64_t without = registry.version<Position>(entity);
    registry.add<Position>(entity);

    EXPECT_EQ(without, 0U);
    EXPECT_GT(registry.version<Position>(entity), before);
}

TEST(Registry, VersionOfATypeRisesAtAddPatchRemoveAndDestroyAndAtNothingElse) {
    ecs::Registry registry;
    std::vector<std::uint64_t> versions = {registry.version<Position>()};
    const auto note = [&] { versions.push_back(registry.version<Position>()); };

    const ecs::Entity entity = registry.create();
    registry.add<Position>(entity);
    note();
    registry.patch<Position>(entity, [](Position&) {});
    note();
    registry.remove<Position>(entity);
    note();
    registry.add<Position>(entity);
    note();
    registry.destroy(entity);
    note();
    registry.add<Tag>(registry.create());
    registry.destroy(registry.create());
    note();

    EXPECT_EQ(versions, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5, 5}));
}

TEST(Registry, DeadEntitiesStayDeadWhenTheirIndexLivesAgain) {
    ecs::Registry registry;
    const ecs::Entity first = make(registry, 1).front();
    registry.destroy(first);
    const ecs::Entity second = registry.create();

    EXPECT_EQ(first.index(), second.index());
    EXPECT_TRUE(registry.alive(second));
    EXPECT_FALSE(registry.alive(first));
    EXPECT_FALSE(registry.has<Position>(first));
    EXPECT_FALSE(registry.alive(ecs::kNoEntity));
}

TEST(Registry, EntitiesThatWereNeverMadeAreNotAlive) {
    ecs::Registry registry;
    const ecs::Entity entity = registry.create();
    registry.destroy(entity);

    EXPECT_FALSE(registry.alive(ecs::Entity::from(0, 1)));
    EXPECT_FALSE(registry.alive(ecs::Entity::from(1, 0)));
}

TEST(Registry, AnIndexIsLeftAloneWhenItsGenerationsAreUsedUp) {
    ecs::Registry registry;
    const ecs::Entity first = registry.create();
    ecs::Entity entity = first;
    for (std::uint32_t i = 0; i < ecs::kNoEntity.generation(); ++i) {
        registry.destroy(entity);
        entity = registry.create();
        ASSERT_EQ(entity.index(), first.index());
    }

    registry.destroy(entity);

    EXPECT_NE(registry.create().index(), first.index());
    EXPECT_FALSE(registry.alive(first));
}

TEST(Registry, RemovalPutsTheLastComponentInThePlaceOfTheRemovedOne) {
    ecs::Registry registry;
    const std::vector<ecs::Entity> entities = make(registry, 4);

    registry.remove<Position>(entities[1]);

    std::vector<float> order;
    registry.each<Position>([&](ecs::Entity, const Position& p) { order.push_back(p.x); });
    EXPECT_EQ(order, (std::vector<float>{0.0F, 3.0F, 2.0F}));
}

TEST(View, GivesTheEntitiesThatHaveEverythingInTheOrderOfTheSmallestStorage) {
    ecs::Registry registry;
    const std::vector<ecs::Entity> entities = make(registry, 5);
    for (const int i : {4, 0, 2})
        registry.add<Tag>(entities[static_cast<std::size_t>(i)]);
    registry.add<Tag>(registry.create());

    std::vector<ecs::Entity> seen;
    for (const ecs::Entity entity : registry.view<Position, Tag>())
        seen.push_back(entity);

    EXPECT_EQ(seen, (std::vector<ecs::Entity>{entities[4], entities[0], entities[2]}));
}

TEST(View, EachHandsOverTheComponentsInTheOrderAskedFor) {
    ecs::Registry registry;
    const ecs::Entity entity = make(registry, 3)[1];
    registry.add<Label>(entity, {"one"});

    int visits = 0;
    registry.each<Position, Label>(
        [&](ecs::Entity at, const Position& position, const Label& label) {
            ++visits;
            EXPECT_EQ(at, entity);
            EXPECT_EQ(position.x, 1.0F);
            EXPECT_EQ(label.text, "one");
        });
    EXPECT_EQ(visits, 1);
}

TEST(View, OfATypeNeverUsedIsEmpty) {
    struct NeverUsed {};
    ecs::Registry registry;
    make(registry, 3);

    for ([[maybe_unused]] const ecs::Entity entity : registry.view<Position, NeverUsed>())
        ADD_FAILURE() << "visited an entity";
    registry.each<NeverUsed>(
        [](ecs::Entity, const NeverUsed&) { ADD_FAILURE() << "visited an entity"; });
}

TEST(View, VisitsEveryEntityOnceWhenSomeAreDestroyedAsTheyAreVisited) {
    ecs::Registry registry;
    const std::vector<ecs::Entity> entities = make(registry, 100);
    std::vector<int> visits(100);

    registry.each<Position>([&](ecs::Entity entity, const Position&) {
        ++visits[entity.index()];
        if (entity.index() % 3 != 0) registry.destroy(entity);
    });

    EXPECT_EQ(visits, std::vector<int>(100, 1));
    EXPECT_EQ(registry.count<Position>(), 34U);
}

TEST(View, VisitsEveryEntityOnceWhenEachLosesItsComponent) {
    ecs::Registry registry;
    const std::vector<ecs::Entity> entities = make(registry, 10);
    for (const ecs::Entity entity : entities)
        registry.add<Tag>(entity);
    int visits = 0;

    for (const ecs::Entity entity : registry.view<Position, Tag>()) {
        registry.remove<Tag>(entity);
        registry.add<Label>(entity);
        ++visits;
    }

    EXPECT_EQ(visits, 10);
    EXPECT_EQ(registry.count<Tag>(), 0U);
    EXPECT_EQ(registry.count<Label>(), 10U);
}

TEST(RegistryDeathTest, MisuseAbortsWithASentence) {
    ecs::Registry registry;
    const ecs::Entity entity = make(registry, 1).front();
    const ecs::Entity dead = make(registry, 1).front();
    registry.destroy(dead);

    EXPECT_DEATH(
        (void)registry.get<Label>(entity), "ecs: entity 0 \\(generation 0\\) has no .*Label");
    EXPECT_DEATH((void)registry.get<Position>(dead), "entity 1 .* is dead and has no .*Position");
    EXPECT_DEATH(registry.remove<Label>(entity), "has no .*Label");
    EXPECT_DEATH(registry.patch<Label>(entity, [](Label&) {}), "has no .*Label");
    EXPECT_DEATH(registry.add<Position>(entity), "already has .*Position");
    EXPECT_DEATH(registry.add<Label>(dead), "entity 1 .* is not alive");
    EXPECT_DEATH(registry.destroy(dead), "is not alive");
}

TEST(ViewDeathTest, AddingAViewedComponentOrTakingOneFromAnotherEntityAborts) {
    ecs::Registry registry;
    const std::vector<ecs::Entity> entities = make(registry, 3);

    EXPECT_DEATH(
        registry.each<Position>([&](ecs::Entity, const Position&) { make(registry, 1); }),
        "while the viewed components");
    EXPECT_DEATH(
        registry.each<Position>(
            [&](ecs::Entity, const Position&) { registry.destroy(entities[2]); }),
        "while the viewed components");
}

} // namespace
