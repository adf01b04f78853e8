// What the truth of one light costs at 1280 x 720: the picture that every measured frame is held
// against. GNOMON_BENCH_SCENE names a .glb; without it, a hundred rings on a floor. The tree over
// the triangles is built once and not part of it. Expected: under 4 s of processor time for a light
// without a size, 2 s on two cores.
//
// Instructions per pixel: valgrind --tool=callgrind with --benchmark_filter of one of them and
// --benchmark_min_time=0.

#include "engine/scene/framing.hpp"
#include "engine/scene/primitives.hpp"
#include "engine/scene/scene_builder.hpp"
#include "engine/scene/views.hpp"
#include "tests/support/worlds.hpp"

#include <benchmark/benchmark.h>

#include <cstdlib>

#include "tools/truth/truth.hpp"

namespace truth {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

scene::World rings() {
    test_support::WorldBuilder builder = test_support::floor_of(30.0F);
    builder.world.assets.meshes.push_back(scene::make_torus(0.8F, 0.25F, 64, 32));
    for (int i = 0; i < 100; ++i)
        builder.add_instance(
            "ring",
            1,
            test_support::at({2.5 * (i % 10) - 11.0, 1.0 + 0.1 * (i % 7), 2.5 * (i / 10) - 11.0}));
    builder.add_light(test_support::sun_light());
    return std::move(builder.world);
}

struct Stage {
    Stage() {
        const char* file = std::getenv("GNOMON_BENCH_SCENE");
        if (file == nullptr)
            world = rings();
        else if (auto built = scene::build_world_from_gltf(file, world); !built)
            failure = engine::to_string(built.error());
        scene::update(world, 0.0F);
        camera = scene::find_camera(world, "", kWidth, kHeight)
                     .value_or(scene::frame_scene(world, kWidth, kHeight));
        lights = scene::placed_lights(world);
        if (lights.empty()) failure = "a scene without a light";
        tracer.update(world);
    }

    scene::World world;
    scene::CameraView camera;
    std::vector<scene::PlacedLight> lights;
    trace::TraceScene tracer;
    std::string failure;
};

const Stage& stage() {
    static const Stage kStage;
    return kStage;
}

/// The first light without its size.
scene::PlacedLight hard_light() {
    scene::PlacedLight light = stage().lights.front();
    light.light.radius = light.light.angular_radius = 0.0F;
    return light;
}

template <class Trace>
void each_picture(benchmark::State& state, Trace trace) {
    if (!stage().failure.empty()) {
        state.SkipWithError(stage().failure.c_str());
        return;
    }
    for ([[maybe_unused]] auto iteration : state)
        trace();
    state.counters["triangles"] = static_cast<double>(stage().tracer.triangle_count());
}

void pixel_centres(benchmark::State& state) {
    each_picture(state, [] {
        benchmark::DoNotOptimize(
            trace::trace_visibility(stage().tracer, stage().camera, hard_light()).depth.data());
    });
}

void with_doubts(benchmark::State& state) {
    each_picture(state, [] {
        benchmark::DoNotOptimize(
            true_visibility(stage().tracer, stage().camera, hard_light()).undecided.data());
    });
}

BENCHMARK(pixel_centres)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(with_doubts)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace

} // namespace truth
