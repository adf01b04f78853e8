// gnomon play: a level in a window; with no display it walks itself and leaves a film and
// pictures; with --seconds or --minutes it only walks, and tells what it holds.

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "tools/gnomon/commands.hpp"
#include "tools/gnomon/failure.hpp"
#include "tools/gnomon/play.hpp"

namespace gnomon {

namespace {

bool has_display() {
    const auto set = [](const char* name) {
        const char* value =
            std::getenv(name); // NOLINT(concurrency-mt-unsafe): nothing else runs yet
        return value != nullptr && *value != '\0';
    };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

int play(const PlayOptions& options) {
    const auto size = options.view.size_px();
    if (!size) return fail(size.error(), kWrongUsage);
    auto level = load_level(options.level);
    if (!level) return fail(level.error(), kBadFile);
    print_warnings(*level);
    if (has_display() && !options.headless && options.soak_seconds <= 0.0) {
        const auto played = play_in_window(*level, options, *size);
        return played ? kFine : fail(played.error(), kNoOpenGl);
    }
    auto studio = Studio::open(size->x, size->y);
    if (!studio) return fail(studio.error(), kNoOpenGl);
    if (options.soak_seconds > 0.0) {
        const auto steady = soak(**studio, *level, options, *size);
        if (!steady) return fail(steady.error(), kCannotDo);
        fmt::print("{}\n", *steady ? "nothing grew" : "FAILED: something grew");
        return *steady ? kFine : kCheckFailed;
    }
    const auto walked = walk_through(**studio, *level, options, *size);
    if (!walked) return fail(walked.error(), kCannotDo);
    fmt::print("{}\n", *walked);
    return kFine;
}

} // namespace

Run add_play(CLI::App& app) {
    auto options = std::make_shared<PlayOptions>();
    CLI::App* command = app.add_subcommand(
        "play", "plays a level in a window, or walks it when there is no display");
    command->add_option("level", options->level, "LEVEL.lua, .glb or .gltf")->capture_default_str();
    command->add_option("--out", options->out, "folder for the film and the pictures of a walk")
        ->capture_default_str();
    command->add_option("--size", options->view.size, "WIDTHxHEIGHT, pixels")
        ->capture_default_str();
    command
        ->add_option(
            "--walk-seconds", options->walk_seconds, "length of the walk; without it once round")
        ->check(CLI::Range(0.5, 600.0));
    command
        ->add_option("--frames", options->window_frames, "close the window after this many frames")
        ->check(CLI::Range(0, 1000000));
    command->add_flag("--walk,--headless", options->headless, "walk even where there is a display");
    constexpr double kSecondsPerMinute = 60.0;
    command
        ->add_option_function<double>(
            "--seconds",
            [options](double seconds) { options->soak_seconds = seconds; },
            "walk this long without pictures; fails when memory grows")
        ->check(CLI::Range(0.1, 86400.0));
    command
        ->add_option_function<double>(
            "--minutes",
            [options](double minutes) { options->soak_seconds = minutes * kSecondsPerMinute; },
            "the same in minutes")
        ->check(CLI::Range(0.01, 1440.0));
    return [options] { return play(*options); };
}

} // namespace gnomon
