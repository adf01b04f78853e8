// gnomon chart: cost against error of every technique and setting, as a page, as SVG and as tables.

#include "engine/scene/views.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>

#include "tools/chart/chart_page.hpp"
#include "tools/chart/drawing.hpp"
#include "tools/chart/overlay.hpp"
#include "tools/chart/tables.hpp"
#include "tools/gnomon/charting.hpp"
#include "tools/gnomon/commands.hpp"
#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/failure.hpp"
#include "tools/gnomon/text_files.hpp"
#include "tools/gnomon/view_options.hpp"

namespace gnomon {

namespace {

namespace fs = std::filesystem;

struct Command {
    std::string scene;
    fs::path out = "out/chart";
    fs::path overlay;
    std::string cost = "measured";
    bool quick = false;
    ChartingOptions charting;
    ViewOptions view;
};

/// Says what is being done, and for how long yet.
class Progress {
public:
    explicit Progress(std::size_t steps) : steps_(steps) {}

    void operator()(const std::string& text) {
        if (text.empty()) return;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        const double left = done_ == 0
                                ? 0.0
                                : spent.count() / static_cast<double>(done_)
                                      * static_cast<double>(steps_ - std::min(done_, steps_));
        const std::string more = done_ == 0 ? std::string() : fmt::format(", {:.0f} s left", left);
        fmt::print(stderr, "[{}/{}{}] {}\n", ++done_, steps_, more, text);
    }

private:
    std::size_t steps_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

engine::Result<chart::Overlay> overlay_of(const fs::path& file) {
    if (file.empty()) return chart::Overlay{};
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
        return engine::Error{
            "could not be read; expected a table of other engines' points", {file.string()}};
    return chart::read_overlay(text.str(), file.string());
}

/// Of one light its chart is also the scene's; of several the scene's comes first.
std::string stem_of(const chart::Chart& chart) {
    return chart.light.empty()
               ? fmt::format("chart_{}", file_word(chart.scene))
               : fmt::format("chart_{}_{}", file_word(chart.scene), file_word(chart.light));
}

engine::Result<void> write_charts(const fs::path& folder, const chart::Findings& findings) {
    if (auto made = make_folder(folder); !made) return made;
    const std::string page = chart::chart_page(findings);
    if (auto written = write_text(folder / "chart.html", page); !written) return written;
    if (auto written = write_text(folder / "chart.csv", chart::csv(findings.charts)); !written)
        return written;
    if (auto written = write_text(folder / "chart.json", chart::json(findings.charts)); !written)
        return written;
    for (const chart::Chart& one : findings.charts) {
        const bool timed = !one.points.empty() && one.points.front().measured_ms;
        const std::string svg = chart::svg_file(chart::drawing(
            one,
            findings.series,
            timed ? chart::Across::measured : chart::Across::predicted,
            chart::usual_up({&one, 1})));
        if (auto written = write_text(folder / (stem_of(one) + ".svg"), svg); !written)
            return written;
    }
    fmt::print(
        "{} ({:.1f} MB) shows {} charts; chart.csv, chart.json and an SVG of each lie beside it\n",
        (folder / "chart.html").string(),
        static_cast<double>(page.size()) / 1e6,
        findings.charts.size());
    return {};
}

std::string about(const Command& command, const Studio& studio, const scene::CameraView& camera) {
    std::string text = fmt::format(
        "Camera '{}', {}x{} pixels, {}. Each light alone, every job redrawn in every frame. ",
        camera.name,
        camera.width,
        camera.height,
        studio.device().renderer);
    if (command.charting.timing.frames > 0)
        text += fmt::format(
            "Times are medians of {} frames with shadows minus those of {} without, in "
            "alternating rounds. ",
            command.charting.timing.frames,
            command.charting.timing.frames);
    else
        text += "Nothing was timed: costs are counts times committed coefficients. ";
    if (!command.overlay.empty())
        text += fmt::format(
            "Hollow marks are other engines', from {}: time and wrong pixels are all that is known "
            "of them.",
            command.overlay.filename().string());
    return text;
}

/// What to try: the command's own list, or everything.
void add_words(Command& command, const Level& level, const shadows::Techniques& techniques) {
    if (!command.charting.words.empty()) return;
    const auto lights = scene::placed_lights(level.world);
    const bool soft = std::any_of(
        lights.begin(), lights.end(), [](const auto& placed) { return is_soft(placed.light); });
    command.charting.words = settings_to_try(techniques, soft, command.quick);
}

int run(Command command) {
    const auto size = command.view.size_px();
    if (!size) return fail(size.error(), kWrongUsage);
    const auto overlay = overlay_of(command.overlay);
    if (!overlay) return fail(overlay.error(), kBadFile);
    auto studio = Studio::open(size->x, size->y);
    if (!studio) return fail(studio.error(), kNoOpenGl);
    const shadows::Techniques& techniques = (*studio)->shadows().techniques();
    for (const std::string& word : command.charting.words)
        if (auto known = options_from_word(word, techniques); !known)
            return fail(known.error(), kWrongUsage);
    auto level = load_level(command.scene);
    if (!level) return fail(level.error(), kBadFile);
    print_warnings(*level);
    const auto camera = choose_camera(*level, command.view.camera, size->x, size->y);
    if (!camera) return fail(camera.error(), kWrongUsage);
    add_words(command, *level, techniques);
    if (command.cost == "predicted") command.charting.timing.frames = 0;

    const auto lights = charted_lights(scene::placed_lights(level->world), command.charting.light);
    if (!lights) return fail(lights.error(), kWrongUsage);
    const std::size_t words = command.charting.words.size();
    Progress progress(lights->size() * (words + 1) + (lights->size() > 1 ? words : 0));
    auto charts =
        chart_level(**studio, *level, *camera, command.charting, [&](const std::string& text) {
            progress(text);
        });
    if (!charts) return fail(charts.error(), kCannotDo);
    chart::Findings findings;
    findings.title = fmt::format("Shadows of {}: cost against error", level->name);
    findings.about = about(command, **studio, *camera);
    findings.series = {chart_series(techniques), overlay->peers};
    findings.charts = *std::move(charts);
    if (const auto peers = overlay->by_scene.find(level->name); peers != overlay->by_scene.end())
        findings.charts.front().peers = peers->second;
    else if (!command.overlay.empty())
        fmt::print(
            stderr,
            "gnomon: {} has no points of scene '{}'\n",
            command.overlay.string(),
            level->name);
    if (auto written = write_charts(command.out, findings); !written)
        return fail(written.error(), kCannotDo);
    return kFine;
}

} // namespace

Run add_chart(CLI::App& app) {
    auto options = std::make_shared<Command>();
    options->charting.timing.frames = 9;
    CLI::App* command = app.add_subcommand(
        "chart", "cost against error of every technique and setting: a page, SVG, CSV, JSON");
    command->add_option("scene", options->scene, "SCENE.lua, .glb or .gltf")->required();
    command->add_option("--out", options->out, "folder for the page and its tables")
        ->capture_default_str();
    add_view_options(*command, options->view);
    command
        ->add_option(
            "--technique",
            options->charting.words,
            "try these instead of everything, several with commas: map@1024:pcf, volume@1, "
            "auto@0.5")
        ->delimiter(',');
    command->add_option("--light", options->charting.light, "one light alone; else every one");
    command->add_flag("--quick", options->quick, "few sizes, one filter, three budgets");
    command
        ->add_option(
            "--cost",
            options->cost,
            "measured: timed frames as well; predicted: counts times coefficients alone, the same "
            "on "
            "every machine")
        ->check(CLI::IsMember({"measured", "predicted"}))
        ->capture_default_str();
    command
        ->add_option(
            "--frames", options->charting.timing.frames, "frames to time, with and without shadows")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command
        ->add_option(
            "--samples",
            options->charting.truth_samples,
            "light samples of the truth of area lights")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    command->add_option(
        "--overlay",
        options->overlay,
        "other engines' points, CSV or JSON: scene, peer, config, cost in ms, wrong in percent");
    return [options] { return run(*options); };
}

} // namespace gnomon
