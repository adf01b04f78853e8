// Random histories against a naive model: the registry and a std::map must tell the same story.

#include "ecs/registry.hpp"
#include "engine/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace {

struct A {
    int value = 0;
};
struct B {
    int value = 0;
};

/// One component type as a map from its owners; versions as the registry defines them.
struct NaiveStorage {
    struct Cell {
        int value = 0;
        std::uint64_t version = 0;
    };
    std::map<ecs::Entity, Cell> cells;
    std::uint64_t version = 0;
};

/// Applies the same random operations to a registry and to its model.
class History {
public:
    explicit History(std::uint64_t seed) : random_(seed) {}

    void step() {
        const std::uint32_t kind = random_.below(100);
        if (kind < 20) {
            create();
        } else if (kind < 28) {
            destroy();
        } else if (random_.below(2) == 0) {
            change<A>(a_);
        } else {
            change<B>(b_);
        }
    }

    void expect_equal() {
        expect_equal_storage<A>(a_);
        expect_equal_storage<B>(b_);
        expect_equal_views();
        for (const ecs::Entity entity : living_)
            ASSERT_TRUE(registry_.alive(entity));
        for (const ecs::Entity entity : dead_) {
            ASSERT_FALSE(registry_.alive(entity));
            ASSERT_FALSE(registry_.has<A>(entity));
        }
    }

private:
    void create() {
        const ecs::Entity entity = registry_.create();
        ASSERT_EQ(std::count(living_.begin(), living_.end(), entity), 0);
        ASSERT_FALSE(dead_.contains(entity)) << "a dead entity came back";
        living_.push_back(entity);
    }

    void destroy() {
        const std::optional<ecs::Entity> entity = any();
        if (!entity) return;
        registry_.destroy(*entity);
        a_.version += a_.cells.erase(*entity);
        b_.version += b_.cells.erase(*entity);
        living_.erase(std::find(living_.begin(), living_.end(), *entity));
        dead_.insert(*entity);
    }

    template <class T>
    void change(NaiveStorage& model) {
        const std::optional<ecs::Entity> entity = any();
        if (!entity) return;
        const int value = static_cast<int>(random_.below(1000));
        if (!model.cells.contains(*entity)) {
            registry_.add<T>(*entity, {value});
            model.cells[*entity] = {value, ++model.version};
        } else if (random_.below(3) == 0) {
            registry_.remove<T>(*entity);
            model.cells.erase(*entity);
            ++model.version;
        } else {
            registry_.patch<T>(*entity, [&](T& component) { component.value += value; });
            model.cells[*entity].value += value;
            model.cells[*entity].version = ++model.version;
        }
    }

    std::optional<ecs::Entity> any() {
        if (living_.empty()) return std::nullopt;
        return living_[random_.below(static_cast<std::uint32_t>(living_.size()))];
    }

    template <class T>
    void expect_equal_storage(const NaiveStorage& model) {
        ASSERT_EQ(registry_.count<T>(), model.cells.size());
        ASSERT_EQ(registry_.version<T>(), model.version);
        std::map<ecs::Entity, int> visited;
        registry_.each<T>([&](ecs::Entity entity, const T& component) {
            ASSERT_TRUE(visited.emplace(entity, component.value).second) << "visited twice";
        });
        ASSERT_EQ(visited.size(), model.cells.size());
        for (const auto& [entity, cell] : model.cells) {
            ASSERT_EQ(visited.at(entity), cell.value);
            ASSERT_EQ(registry_.get<T>(entity).value, cell.value);
            ASSERT_EQ(registry_.version<T>(entity), cell.version);
        }
        for (const ecs::Entity entity : living_)
            ASSERT_EQ(registry_.has<T>(entity), model.cells.contains(entity));
    }

    void expect_equal_views() {
        std::set<ecs::Entity> expected;
        for (const auto& [entity, cell] : a_.cells) {
            if (b_.cells.contains(entity)) expected.insert(entity);
        }
        std::set<ecs::Entity> walked;
        for (const ecs::Entity entity : registry_.view<A, B>())
            ASSERT_TRUE(walked.insert(entity).second) << "visited twice";
        std::set<ecs::Entity> called;
        registry_.each<B, A>([&](ecs::Entity entity, const B& b, const A& a) {
            called.insert(entity);
            ASSERT_EQ(a.value, a_.cells.at(entity).value);
            ASSERT_EQ(b.value, b_.cells.at(entity).value);
        });
        ASSERT_EQ(walked, expected);
        ASSERT_EQ(called, expected);
    }

    engine::Random random_;
    ecs::Registry registry_;
    std::vector<ecs::Entity> living_;
    std::set<ecs::Entity> dead_;
    NaiveStorage a_;
    NaiveStorage b_;
};

TEST(RegistryProperty, AgreesWithANaiveModelOverRandomHistories) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        History history(seed);
        for (int step = 0; step < 400; ++step) {
            history.step();
            if (step % 16 == 0) history.expect_equal();
            if (HasFatalFailure()) return;
        }
        history.expect_equal();
    }
}

TEST(RegistryProperty, DestroyingWhileWalkingVisitsEachEntityOnce) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        engine::Random random(seed);
        ecs::Registry registry;
        std::set<ecs::Entity> both;
        for (int i = 0; i < 200; ++i) {
            const ecs::Entity entity = registry.create();
            const bool has_a = random.below(3) != 0;
            const bool has_b = random.below(2) != 0;
            if (has_a) registry.add<A>(entity);
            if (has_b) registry.add<B>(entity);
            if (has_a && has_b) both.insert(entity);
        }

        std::set<ecs::Entity> visited;
        registry.each<A, B>([&](ecs::Entity entity, const A&, const B&) {
            ASSERT_TRUE(visited.insert(entity).second) << "visited twice";
            const std::uint32_t fate = random.below(4);
            if (fate == 0) registry.destroy(entity);
            if (fate == 1) registry.remove<A>(entity);
            if (fate == 2) registry.remove<B>(entity);
        });

        ASSERT_EQ(visited, both);
    }
}

TEST(RegistryProperty, TheSameHistoryGivesTheSameEntitiesAndTheSameOrder) {
    const auto run = [] {
        engine::Random random(5);
        ecs::Registry registry;
        std::vector<ecs::Entity> entities;
        for (int i = 0; i < 500; ++i) {
            entities.push_back(registry.create());
            registry.add<A>(entities.back(), {i});
            if (random.below(3) != 0) continue;
            const std::uint32_t at = random.below(static_cast<std::uint32_t>(entities.size()));
            registry.destroy(entities[at]);
            entities.erase(entities.begin() + at);
        }
        std::vector<std::pair<ecs::Entity, int>> order;
        registry.each<A>(
            [&](ecs::Entity entity, const A& a) { order.emplace_back(entity, a.value); });
        return order;
    };

    EXPECT_EQ(run(), run());
}

} // namespace
