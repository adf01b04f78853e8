#include "tools/gnomon/measuring.hpp"

#include "engine/scene/views.hpp"

#include <optional>
#include <utility>

#include "tools/gnomon/measurement.hpp"
#include "tools/gnomon/moving_rows.hpp"
#include "tools/gnomon/progress.hpp"
#include "tools/gnomon/row_journal.hpp"
#include "tools/gnomon/row_key.hpp"
#include "tools/gnomon/still_rows.hpp"

namespace gnomon {

namespace {

/// The rows of one light and protocol, in the order of the techniques; those that are known already
/// are there.
struct Batch {
    std::size_t light = 0;
    std::string protocol;
    std::vector<nlohmann::json> keys;
    std::vector<std::optional<measure::Row>> rows;

    [[nodiscard]] std::vector<std::string> missing(const MeasureOptions& options) const {
        std::vector<std::string> techniques;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (!rows[i]) techniques.push_back(options.techniques[i]);
        return techniques;
    }
};

engine::Result<std::vector<Batch>> make_batches(
    const Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    const std::string& renderer) {
    nlohmann::json common;
    if (options.journal != nullptr) {
        auto key = level_key(level, camera, options, renderer);
        if (!key) return key.error();
        common = *std::move(key);
    }
    std::vector<Batch> batches;
    const auto lights = scene::placed_lights(level.world);
    for (std::size_t light = 0; light < lights.size(); ++light)
        for (const std::string& protocol : options.protocols) {
            Batch batch{light, protocol, {}, {}};
            for (const std::string& technique : options.techniques) {
                if (options.journal == nullptr) {
                    batch.rows.emplace_back();
                    continue;
                }
                batch.keys.push_back(
                    row_key(common, options, lights[light].name, technique, protocol));
                batch.rows.push_back(options.journal->find(batch.keys.back()));
            }
            batches.push_back(std::move(batch));
        }
    return batches;
}

double work(const std::vector<Batch>& batches, const MeasureOptions& options) {
    double units = 0.0;
    for (const Batch& batch : batches)
        units += static_cast<double>(batch.missing(options).size())
                 * (batch.protocol == measure::kStill ? 1 : options.moving_frames);
    return units;
}

/// Measures what is missing; each row goes to the journal as soon as it is finished.
engine::Result<void>
complete(Measurement& measurement, const scene::CameraView& camera, Batch& batch) {
    const MeasureOptions& options = measurement.options();
    const std::vector<std::string> missing = batch.missing(options);
    if (missing.empty()) return {};
    const RowSink take = [&](measure::Row row) -> engine::Result<void> {
        std::size_t place = 0;
        while (batch.rows[place] || options.techniques[place] != row.technique)
            ++place;
        if (options.journal != nullptr)
            if (auto kept = options.journal->append(batch.keys[place], row); !kept) return kept;
        batch.rows[place] = std::move(row);
        return {};
    };
    return batch.protocol == measure::kStill
               ? measure_stills(measurement, camera, batch.light, missing, take)
               : measure_motion(measurement, camera, batch.light, batch.protocol, missing, take);
}

} // namespace

engine::Result<void> measure_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const MeasureOptions& options,
    measure::Report& report) {
    std::optional<Progress> own_progress;
    Progress& progress = options.progress != nullptr ? *options.progress : own_progress.emplace();
    auto batches = make_batches(level, camera, options, studio.device().renderer);
    if (!batches) return batches.error();
    progress.begin_part(work(*batches, options));
    Measurement measurement(studio, level, options, progress);
    if (auto drawn = measurement.draw(camera, "none"); !drawn) return drawn;
    for (Batch& batch : *batches) {
        if (auto completed = complete(measurement, camera, batch); !completed) return completed;
        for (std::optional<measure::Row>& row : batch.rows)
            report.add(*std::move(row));
    }
    return {};
}

} // namespace gnomon
