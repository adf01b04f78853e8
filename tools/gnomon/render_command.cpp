// gnomon render: one scene, headless, into pictures, plans and times. The contract other tools rely
// on.

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "tools/gnomon/commands.hpp"
#include "tools/gnomon/failure.hpp"
#include "tools/gnomon/frame_times.hpp"
#include "tools/gnomon/render_files.hpp"
#include "tools/gnomon/view_options.hpp"

namespace gnomon {

namespace {

constexpr float kTimeStep = 1.0F / 60.0F;

struct RenderOptions {
    std::string scene;
    std::filesystem::path out = "out/render";
    ViewOptions view;
    ShadowOptions shadow;
    TimingOptions timing;
    bool play = false;
    bool hash = false;
    std::uint64_t seed = 1;
};

/// Draws frames of the level; the clock stands still unless the level is played.
class Take {
public:
    Take(Studio& studio, Level& level, const RenderOptions& options, scene::CameraView camera)
        : studio_(studio),
          level_(level),
          options_(options),
          camera_(std::move(camera)) {}

    engine::Result<void> draw(bool with_shadows) {
        if (options_.play) {
            advance(level_, kTimeStep);
            auto camera =
                choose_camera(level_, options_.view.camera, camera_.width, camera_.height);
            if (!camera) return camera.error();
            camera_ = *camera;
        }
        return studio_.draw(level_, camera_, with_shadows);
    }

private:
    Studio& studio_;
    Level& level_;
    const RenderOptions& options_;
    scene::CameraView camera_;
};

int render(const RenderOptions& options) {
    const auto size = options.view.size_px();
    if (!size) return fail(size.error(), kWrongUsage);
    auto level = load_level(options.scene);
    if (!level) return fail(level.error(), kBadFile);
    print_warnings(*level);
    const auto camera = choose_camera(*level, options.view.camera, size->x, size->y);
    if (!camera) return fail(camera.error(), kWrongUsage);
    auto studio = Studio::open(size->x, size->y);
    if (!studio) return fail(studio.error(), kNoOpenGl);
    Studio& s = **studio;
    s.shadows().always_refresh = options.shadow.refresh == "always";
    const auto shadow =
        options_from_word(options.shadow.technique, s.shadows().techniques(), options.shadow);
    if (!shadow) return fail(shadow.error(), kWrongUsage);
    override_wishes(level->shadows, *shadow);

    Take take(s, *level, options, *camera);
    if (const auto missing = unsupported(s, *level, *shadow)) {
        fmt::print("unsupported: {}\n", *missing);
        return kCannotDo;
    }
    if (auto drawn = take.draw(true); !drawn) return fail(drawn.error(), kCannotDo);
    if (const auto unserved = s.shadows().unserved(); !unserved.empty()) {
        fmt::print("unsupported: {}\n", unserved.front());
        return kCannotDo;
    }
    std::optional<FrameTimes> times;
    if (options.timing.frames > 0) {
        auto timed = time_frames(s, options.timing, [&](bool with) { return take.draw(with); });
        if (!timed) return fail(timed.error(), kCannotDo);
        times = *std::move(timed);
        if (auto drawn = take.draw(true); !drawn) return fail(drawn.error(), kCannotDo);
    }
    if (auto written = write_render_files(s, options.out, times, options.hash); !written)
        return fail(written.error(), kCannotDo);
    return kFine;
}

} // namespace

Run add_render(CLI::App& app) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        app.add_subcommand("render", "draws a scene headless: pictures, masks, plans and times");
    command->add_option("scene", options->scene, "SCENE.lua, .glb or .gltf")->required();
    command->add_option("--out", options->out, "folder for the files")->capture_default_str();
    add_view_options(*command, options->view);
    add_shadow_options(*command, options->shadow);
    command
        ->add_option("--frames", options->timing.frames, "frames to time, with and without shadows")
        ->check(CLI::Range(0, 100000));
    command->add_option("--warmup", options->timing.warmup, "frames before each timed round")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    command->add_option("--seconds", options->timing.seconds, "stop timing after this long")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_flag("--play", options->play, "let the level's clock run, 1/60 s a frame");
    command->add_option("--seed", options->seed, "of everything random");
    command->add_flag("--hash", options->hash, "print a hash of every picture");
    return [options] { return render(*options); };
}

} // namespace gnomon
