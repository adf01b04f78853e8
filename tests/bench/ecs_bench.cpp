// What the registry costs, and how far its walks are from loops written by hand.
//
// Each walk runs in turn with its hand-written twin on the same data; the counter `by_hand_ratio`
// is the median time of the one over the median time of the other. Expected: at most 1.5 for one
// component, 1.2 for more.

#include "ecs/registry.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

namespace {

struct Position {
    float x = 1.0F;
    float y = 2.0F;
    float z = 3.0F;
};
struct Velocity {
    float x = 0.5F;
    float y = 0.25F;
    float z = 0.125F;
};
struct Mass {
    float kilograms = 80.0F;
};

/// Packed values with their owners: a storage as one writes it for a single loop.
template <class T>
struct ByHand {
    ecs::SparseSet owners;
    std::vector<T> values;

    void add(ecs::Entity entity, T value) {
        owners.insert(entity);
        values.push_back(value);
    }
};

/// All have a Position, every second one a Velocity, every third one a Mass.
struct Crowd {
    ecs::Registry registry;
    std::vector<ecs::Entity> entities;
    ByHand<Position> positions;
    ByHand<Velocity> velocities;
    ByHand<Mass> masses;

    explicit Crowd(std::int64_t count) {
        for (std::int64_t i = 0; i < count; ++i) {
            const ecs::Entity entity = registry.create();
            entities.push_back(entity);
            const Position position{static_cast<float>(i), 2.0F, 3.0F};
            registry.add(entity, position);
            positions.add(entity, position);
            if (i % 2 == 0) {
                registry.add(entity, Velocity{});
                velocities.add(entity, {});
            }
            if (i % 3 == 0) {
                registry.add(entity, Mass{});
                masses.add(entity, {});
            }
        }
    }
};

template <class Function>
double seconds(Function&& function) {
    const auto start = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

template <class Walk, class ByHandWalk>
void compare(benchmark::State& state, Walk&& walk, ByHandWalk&& by_hand) {
    std::vector<double> walk_times;
    std::vector<double> by_hand_times;
    for ([[maybe_unused]] auto iteration : state) {
        by_hand_times.push_back(seconds([&] { benchmark::DoNotOptimize(by_hand()); }));
        walk_times.push_back(seconds([&] { benchmark::DoNotOptimize(walk()); }));
        state.SetIterationTime(walk_times.back());
    }
    state.counters["by_hand_ratio"] = median(walk_times) / median(by_hand_times);
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void walk_one(benchmark::State& state) {
    const Crowd crowd(state.range(0));
    compare(
        state,
        [&] {
            float sum = 0.0F;
            crowd.registry.each<Position>(
                [&](ecs::Entity, const Position& p) { sum += p.x + p.y * p.z; });
            return sum;
        },
        [&] {
            float sum = 0.0F;
            for (const Position& p : crowd.positions.values)
                sum += p.x + p.y * p.z;
            return sum;
        });
}

void walk_two(benchmark::State& state) {
    const Crowd crowd(state.range(0));
    compare(
        state,
        [&] {
            float sum = 0.0F;
            crowd.registry.each<Position, Velocity>(
                [&](ecs::Entity, const Position& p, const Velocity& v) { sum += p.x * v.x + v.y; });
            return sum;
        },
        [&] {
            float sum = 0.0F;
            const ByHand<Velocity>& driver = crowd.velocities;
            for (std::size_t i = 0; i < driver.values.size(); ++i) {
                const std::uint32_t at = crowd.positions.owners.find_index(driver.owners[i]);
                if (at == ecs::SparseSet::kAbsent) continue;
                sum += crowd.positions.values[at].x * driver.values[i].x + driver.values[i].y;
            }
            return sum;
        });
}

void walk_three(benchmark::State& state) {
    const Crowd crowd(state.range(0));
    compare(
        state,
        [&] {
            float sum = 0.0F;
            crowd.registry.each<Position, Velocity, Mass>(
                [&](ecs::Entity, const Position& p, const Velocity& v, const Mass& m) {
                    sum += p.x * v.x * m.kilograms;
                });
            return sum;
        },
        [&] {
            float sum = 0.0F;
            const ByHand<Mass>& driver = crowd.masses;
            for (std::size_t i = 0; i < driver.values.size(); ++i) {
                const ecs::Entity entity = driver.owners[i];
                const std::uint32_t p = crowd.positions.owners.find_index(entity);
                if (p == ecs::SparseSet::kAbsent) continue;
                const std::uint32_t v = crowd.velocities.owners.find_index(entity);
                if (v == ecs::SparseSet::kAbsent) continue;
                sum += crowd.positions.values[p].x * crowd.velocities.values[v].x
                       * driver.values[i].kilograms;
            }
            return sum;
        });
}

void create(benchmark::State& state) {
    for ([[maybe_unused]] auto iteration : state) {
        ecs::Registry registry;
        state.SetIterationTime(seconds([&] {
            for (std::int64_t i = 0; i < state.range(0); ++i)
                benchmark::DoNotOptimize(registry.create());
        }));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void add(benchmark::State& state) {
    for ([[maybe_unused]] auto iteration : state) {
        Crowd crowd(0);
        for (std::int64_t i = 0; i < state.range(0); ++i)
            crowd.entities.push_back(crowd.registry.create());
        state.SetIterationTime(seconds([&] {
            for (const ecs::Entity entity : crowd.entities)
                crowd.registry.add(entity, Position{});
        }));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The same operation on every entity of a fresh crowd.
template <class Operation>
void on_all(benchmark::State& state, Operation&& operation) {
    for ([[maybe_unused]] auto iteration : state) {
        Crowd crowd(state.range(0));
        state.SetIterationTime(seconds([&] {
            for (const ecs::Entity entity : crowd.entities)
                operation(crowd.registry, entity);
        }));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void remove(benchmark::State& state) {
    on_all(state, [](ecs::Registry& registry, ecs::Entity entity) {
        registry.remove<Position>(entity);
    });
}

void patch(benchmark::State& state) {
    on_all(state, [](ecs::Registry& registry, ecs::Entity entity) {
        registry.patch<Position>(entity, [](Position& position) { position.x += 1.0F; });
    });
}

void destroy(benchmark::State& state) {
    on_all(state, [](ecs::Registry& registry, ecs::Entity entity) { registry.destroy(entity); });
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->UseManualTime()->Unit(
        benchmark::kMicrosecond);
}

BENCHMARK(create)->Apply(sizes);
BENCHMARK(add)->Apply(sizes)->MinTime(0.05);
BENCHMARK(patch)->Apply(sizes)->MinTime(0.05);
BENCHMARK(remove)->Apply(sizes)->MinTime(0.05);
BENCHMARK(destroy)->Apply(sizes)->MinTime(0.05);
BENCHMARK(walk_one)->Apply(sizes);
BENCHMARK(walk_two)->Apply(sizes);
BENCHMARK(walk_three)->Apply(sizes);

} // namespace
