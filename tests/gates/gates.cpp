#include "tests/gates/gates.hpp"

#include "engine/core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "tools/gnomon/measuring.hpp"
#include "tools/gnomon/studio.hpp"

namespace gates {

namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;
constexpr int kSamples = 64;

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

gnomon::MeasureOptions options_for(std::span<const Promise> promised) {
    gnomon::MeasureOptions options;
    options.techniques.clear();
    options.protocols.clear();
    options.moving_frames = promised.front().frames;
    options.truth_samples = kSamples;
    options.timing.frames = 0; // costs in gates are counters, never times
    for (const Promise& one : promised) {
        add_once(options.techniques, one.technique);
        for (const Gate& gate : one.gates)
            add_once(options.protocols, gate.protocol);
    }
    return options;
}

/// Nothing where the group has no such column.
template <class Group>
std::optional<measure::Figure>
find_in(const std::optional<Group>& group, const std::string& name, const std::string& note) {
    for (const measure::FigureColumn<Group>& column : measure::columns_of<Group>()) {
        if (column.name != name) continue;
        if (group) return column.access.get(*group);
        return measure::Figure::missing(note.empty() ? "not measured" : note);
    }
    return std::nullopt;
}

std::string said(const measure::Figure& figure) {
    return figure.known() ? fmt::format("{:.4g}", figure.value())
                          : fmt::format("missing ({})", figure.reason());
}

} // namespace

const Promise& promise(const std::string& scene, const std::string& technique) {
    const auto found = std::find_if(promises().begin(), promises().end(), [&](const Promise& one) {
        return one.scene == scene && one.technique == technique;
    });
    CHECK(found != promises().end());
    return *found;
}

std::vector<std::string> scenes() {
    std::vector<std::string> names;
    for (const Promise& one : promises())
        add_once(names, one.scene);
    return names;
}

engine::Result<std::vector<measure::Row>>
measure_promises(std::span<const Promise> promised, const shadows::Remedies& remedies) {
    CHECK(!promised.empty());
    auto studio = gnomon::Studio::open(kWidth, kHeight);
    if (!studio) return studio.error();
    (*studio)->shadows().remedies = remedies;
    auto level = gnomon::load_level(
        fmt::format("{}/tests/gates/scenes/{}.lua", PROJECT_SOURCE_DIR, promised[0].scene));
    if (!level) return level.error();
    const auto camera = gnomon::choose_camera(*level, "", kWidth, kHeight);
    if (!camera) return camera.error();
    measure::Report report;
    const auto measured =
        gnomon::measure_level(**studio, *level, *camera, options_for(promised), report);
    if (!measured) return measured.error();
    return report.rows();
}

measure::Figure figure_of(const measure::Row& row, const std::string& name) {
    if (const auto still = find_in(row.figures, name, row.note)) return *still;
    const auto moving = find_in(row.motion, name, row.note);
    CHECK(moving.has_value());
    return *moving;
}

const measure::Row&
row_of(std::span<const measure::Row> rows, const Promise& promised, const std::string& protocol) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const measure::Row& one) {
        return one.technique == promised.technique && one.protocol == protocol;
    });
    CHECK(row != rows.end());
    return *row;
}

std::vector<Broken> broken_gates(const Promise& promised, std::span<const measure::Row> rows) {
    std::vector<Broken> broken;
    for (const Gate& gate : promised.gates) {
        const measure::Row& row = row_of(rows, promised, gate.protocol);
        const measure::Figure figure = figure_of(row, gate.figure);
        if (figure.known() && figure.value() <= gate.at_most) continue;
        broken.push_back(
            {gate,
             fmt::format(
                 "{}, light '{}', {}, {}: {} is {}, expected at most {} ({})\n  {}",
                 promised.scene,
                 row.light,
                 promised.technique,
                 gate.protocol,
                 gate.figure,
                 said(figure),
                 gate.at_most,
                 gate.why,
                 command_of(promised, gate.protocol))});
    }
    return broken;
}

std::string command_of(const Promise& promised, const std::string& protocol) {
    return fmt::format(
        "gnomon measure tests/gates/scenes/{}.lua --size {}x{} --moving-frames {} --samples {} "
        "--technique {} --protocol {} --out out/gates",
        promised.scene,
        kWidth,
        kHeight,
        promised.frames,
        kSamples,
        promised.technique,
        protocol);
}

} // namespace gates
