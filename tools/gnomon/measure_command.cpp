// gnomon measure: how wrong each technique's shadows are, held against ray-traced truth, standing
// still and in motion.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

#include "tools/gnomon/commands.hpp"
#include "tools/gnomon/failure.hpp"
#include "tools/gnomon/measuring.hpp"
#include "tools/gnomon/motion_protocols.hpp"
#include "tools/gnomon/progress.hpp"
#include "tools/gnomon/row_journal.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

struct Command {
    std::vector<std::string> scenes;
    std::filesystem::path out = "out/measure";
    bool fresh = false;
    MeasureOptions measure;
    ViewOptions view;
};

engine::Result<void>
write_reports(const std::filesystem::path& folder, const measure::Report& report) {
    if (auto written = write_text(folder / "measure.csv", report.csv()); !written) return written;
    return write_text(folder / "measure.json", report.json().dump(1) + "\n");
}

int measure_scenes(const Command& command) {
    const auto size = command.view.size_px();
    if (!size) return fail(size.error(), kWrongUsage);
    if (auto made = make_folder(command.out); !made) return fail(made.error(), kCannotDo);
    auto studio = Studio::open(size->x, size->y);
    if (!studio) return fail(studio.error(), kNoOpenGl);
    for (const std::string& technique : command.measure.techniques)
        if (auto known = options_from_word(technique, (*studio)->shadows().techniques()); !known)
            return fail(known.error(), kWrongUsage);
    auto journal = RowJournal::open(command.out / "measure.rows.jsonl", command.fresh);
    if (!journal) return fail(journal.error(), kCannotDo);
    for (const std::string& warning : journal->warnings())
        fmt::print(stderr, "warning: {}\n", warning);
    measure::Report report;
    Progress progress(static_cast<int>(command.scenes.size()));
    for (const std::string& file : command.scenes) {
        auto level = load_level(file);
        if (!level) return fail(level.error(), kBadFile);
        print_warnings(*level);
        const auto camera = choose_camera(*level, command.view.camera, size->x, size->y);
        if (!camera) return fail(camera.error(), kWrongUsage);
        MeasureOptions options = command.measure;
        options.pictures = command.out;
        options.journal = &*journal;
        options.progress = &progress;
        if (auto measured = measure_level(**studio, *level, *camera, options, report); !measured)
            return fail(measured.error(), kCannotDo);
    }
    if (const std::size_t known = report.rows().size() - journal->appended(); known > 0)
        fmt::print(
            stderr,
            "{} of {} rows were measured before and are in {}; --fresh measures them again\n",
            known,
            report.rows().size(),
            journal->file().string());
    fmt::print("{}", report.table());
    if (auto written = write_reports(command.out, report); !written)
        return fail(written.error(), kCannotDo);
    fmt::print("\n{} and measure.json hold every figure\n", (command.out / "measure.csv").string());
    return kFine;
}

} // namespace

Run add_measure(CLI::App& app) {
    auto options = std::make_shared<Command>();
    CLI::App* command =
        app.add_subcommand("measure", "holds shadows against ray-traced truth: table, CSV, JSON");
    command->add_option("scene", options->scenes, "SCENE.lua, .glb or .gltf")->required();
    command->add_option("--out", options->out, "folder for tables and pictures")
        ->capture_default_str();
    command->add_flag(
        "--fresh",
        options->fresh,
        "measure every row again; else those that an earlier run left in the folder are taken");
    add_view_options(*command, options->view);
    command
        ->add_option(
            "--technique",
            options->measure.techniques,
            "auto, map, or names of techniques, several with commas; map@1024, map@1024:pcf and "
            "auto@0.5 say more")
        ->delimiter(',');
    command
        ->add_option(
            "--protocol",
            options->measure.protocols,
            fmt::format("what moves: {}, several with commas", fmt::join(protocol_names(), ", ")))
        ->delimiter(',')
        ->check(CLI::IsMember(protocol_names()))
        ->capture_default_str();
    command
        ->add_option(
            "--moving-frames",
            options->measure.moving_frames,
            "frames of a sequence in which something moves, 1/60 s each")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command
        ->add_option(
            "--frames", options->measure.timing.frames, "frames to time, with and without shadows")
        ->check(CLI::Range(0, 100000));
    command
        ->add_option(
            "--samples",
            options->measure.truth_samples,
            "light samples of the truth of area lights")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    return [options] { return measure_scenes(*options); };
}

} // namespace gnomon
