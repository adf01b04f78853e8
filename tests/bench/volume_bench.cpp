// What a hero's stencil volume costs when it, or the light, has moved: facings, outline, caps and
// sides of a torus of 50,000 triangles, on one core. Expected: under 2 ms.
//
// Instructions per triangle: valgrind --tool=callgrind with --benchmark_filter of one of them and
// --benchmark_min_time=0, divided by iterations and triangles.

#include "engine/scene/primitives.hpp"
#include "systems/shadows/volumes/shadow_volume.hpp"
#include "systems/shadows/volumes/start_count.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>

namespace shadows {

namespace {

const scene::Mesh& hero() {
    static const scene::Mesh kHero = scene::make_torus(1.0F, 0.35F, 250, 100);
    return kHero;
}

const CasterSurface& hero_surface() {
    static const CasterSurface kSurface = make_caster_surface(hero());
    return kSurface;
}

void report(benchmark::State& state, const ShadowVolume& volume) {
    state.counters["triangles"] = static_cast<double>(hero_surface().triangle_count());
    state.counters["outline"] = volume.outline_edges;
    state.counters["drawn"] = static_cast<double>(volume.indices.size() / 3);
}

/// The light goes round. @param w 1 a lamp, 0 a sun
void moving_light(benchmark::State& state, double w, bool surrounded) {
    const CasterSurface& surface = hero_surface();
    VolumeBuilder builder;
    ShadowVolume volume;
    double angle = 0.0;
    for ([[maybe_unused]] auto iteration : state) {
        angle += 0.01;
        const glm::dvec4 light(3.0 * std::cos(angle), 4.0, 3.0 * std::sin(angle), w);
        builder.build(surface, hero().positions, light, surrounded, volume);
        benchmark::DoNotOptimize(volume.indices.data());
    }
    report(state, volume);
}

void sun_moves(benchmark::State& state) {
    moving_light(state, 0.0, false);
}
void lamp_moves(benchmark::State& state) {
    moving_light(state, 1.0, false);
}
void lamp_moves_inside(benchmark::State& state) {
    moving_light(state, 1.0, true);
}

/// The caster bends from frame to frame.
void pose_changes(benchmark::State& state) {
    const std::vector<glm::vec3>& rest = hero().positions;
    std::vector<std::vector<glm::vec3>> poses(8, rest);
    for (std::size_t i = 0; i < poses.size(); ++i)
        for (glm::vec3& p : poses[i])
            p.x += 0.2F * std::sin(3.0F * p.z + static_cast<float>(i));
    const CasterSurface& surface = hero_surface();
    VolumeBuilder builder;
    ShadowVolume volume;
    std::size_t frame = 0;
    for ([[maybe_unused]] auto iteration : state) {
        builder.build(surface, poses[frame++ % poses.size()], {1.0, 4.0, 0.5, 1.0}, false, volume);
        benchmark::DoNotOptimize(volume.indices.data());
    }
    report(state, volume);
}

/// Once per mesh.
void surface(benchmark::State& state) {
    for ([[maybe_unused]] auto iteration : state)
        benchmark::DoNotOptimize(make_caster_surface(hero()));
}

/// The eye is in the ring's shadow: what it is counted from is found anew in every frame.
void eye_in_shadow(benchmark::State& state) {
    const glm::dvec4 light(0.3, 1.0, 0.1, 0.0);
    ShadowVolume volume;
    VolumeBuilder().build(hero_surface(), hero().positions, light, false, volume);
    scene::CameraView camera;
    camera.position = glm::dvec3(1.0, 0.0, 0.0) - 2.0 * glm::dvec3(light);
    std::optional<int> count;
    for ([[maybe_unused]] auto iteration : state) {
        count = start_count(
            camera,
            volume,
            hero().positions,
            glm::dmat4(1.0),
            light,
            {glm::dvec3(hero().bounds.min), glm::dvec3(hero().bounds.max)});
        benchmark::DoNotOptimize(count);
    }
    state.counters["count"] = count.value_or(-1);
    report(state, volume);
}

/// Once per hero.
void proxies(benchmark::State& state) {
    std::vector<scene::Proxy> made;
    for ([[maybe_unused]] auto iteration : state)
        made = scene::make_proxies(hero());
    for (std::size_t i = 0; i < made.size(); ++i) {
        state.counters[fmt::format("triangles {}", i + 1)] = made[i].triangle_count();
        state.counters[fmt::format("mm off {}", i + 1)] =
            1000.0 * static_cast<double>(made[i].deviation);
    }
}

BENCHMARK(sun_moves)->Unit(benchmark::kMillisecond);
BENCHMARK(lamp_moves)->Unit(benchmark::kMillisecond);
BENCHMARK(lamp_moves_inside)->Unit(benchmark::kMillisecond);
BENCHMARK(pose_changes)->Unit(benchmark::kMillisecond);
BENCHMARK(eye_in_shadow)->Unit(benchmark::kMillisecond);
BENCHMARK(surface)->Unit(benchmark::kMillisecond);
BENCHMARK(proxies)->Unit(benchmark::kMillisecond);

} // namespace

} // namespace shadows
