#include "tools/gnomon/charting.hpp"

#include "engine/core/text.hpp"
#include "engine/scene/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/gnomon/chart_points.hpp"
#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/row_pictures.hpp"
#include "tools/gnomon/serving.hpp"
#include "tools/gnomon/view_options.hpp"
#include "tools/measure/figures.hpp"
#include "tools/page/picture.hpp"
#include "tools/truth/truth_files.hpp"

namespace gnomon {

namespace {

constexpr int kMostPictureWidth = 640;
constexpr int kLeastPictureWidth = 240;
/// What all pictures of a page may take, and what a pixel of them takes as JPEG.
constexpr double kPictureBytes = 4.5e6;
constexpr double kBytesPerPixel = 0.12;

/// Wide enough to see, small enough that the page stays one that a browser opens at once.
int picture_width(std::size_t pictures, const scene::CameraView& camera) {
    const double pixels = kPictureBytes / kBytesPerPixel / static_cast<double>(pictures);
    const double width = std::sqrt(pixels * camera.width / camera.height);
    return std::clamp(static_cast<int>(width), kLeastPictureWidth, kMostPictureWidth);
}

engine::Image without_alpha(const engine::Image& image) {
    if (image.channels != 4) return image;
    engine::Image rgb(image.width, image.height, 3);
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        std::copy_n(&image.bytes[4 * i], 3, &rgb.bytes[3 * i]);
    return rgb;
}

/// Of a pair that nothing serves, what the technique that was asked says; where all were asked,
/// what all say.
std::string why_unserved(const shadows::ShadowSystem& system) {
    for (const shadows::Plan& pair : system.plan().plans)
        for (const shadows::Rejection& rejection : pair.rejected)
            if (pair.entries.empty() && rejection.reason != "not pinned")
                return fmt::format(
                    "{} on receiver '{}': {}",
                    rejection.technique,
                    system.scene().receiver(pair.receiver).name,
                    rejection.reason);
    return system.unserved().front();
}

/// One level at work.
class Charting {
public:
    Charting(
        Studio& studio,
        Level& level,
        const scene::CameraView& camera,
        const ChartingOptions& options,
        const std::function<void(const std::string&)>& progress)
        : studio_(studio),
          level_(level),
          camera_(camera),
          options_(options),
          progress_(progress),
          settings_(level.shadows),
          lights_(scene::placed_lights(level.world)) {
        studio_.shadows().always_refresh = true;
        level_.shadows.overriding.clear();
    }
    ~Charting() {
        studio_.shadows().always_refresh = false;
        level_.shadows = settings_;
    }
    Charting(const Charting&) = delete;
    Charting& operator=(const Charting&) = delete;

    engine::Result<std::vector<chart::Chart>> charts();

private:
    engine::Result<chart::Chart> of_light(std::size_t light, const trace::TraceScene& tracer);
    engine::Result<chart::Chart> of_all(const std::vector<chart::Chart>& of_lights);
    engine::Result<chart::Point>
    point(const std::string& word, std::size_t light, const truth::TruthImage& truth);
    engine::Result<void> draw(const std::string& word, std::optional<std::size_t> only);
    /// @param picture 1, 3 or 4 channels
    [[nodiscard]] std::string url(const engine::Image& picture) const {
        return page::jpeg_url(page::at_most_wide(without_alpha(picture), width_));
    }
    /// Same reasons of one series become one line.
    static void refuse(chart::Chart& chart, const std::string& word, const std::string& reason);

    Studio& studio_;
    Level& level_;
    const scene::CameraView& camera_;
    const ChartingOptions& options_;
    const std::function<void(const std::string&)>& progress_;
    shadows::ShadowSettings settings_; ///< of the level, to come back to
    std::vector<scene::PlacedLight> lights_;
    gpu::Counters without_; ///< of a frame without shadows
    int width_;             ///< of pictures, px
};

/// With all lights, or with the shadows of one alone. Errors: why the setting cannot serve it.
engine::Result<void> Charting::draw(const std::string& word, std::optional<std::size_t> only) {
    const auto asked = options_from_word(word, studio_.shadows().techniques());
    if (!asked) return asked.error();
    level_.shadows.rules = settings_.rules;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        scene::RuleDescription rule;
        rule.light = lights_[i].name;
        rule.shadow = asked->wish(lights_[i].light.kind);
        if (only && *only != i) rule.shadow.technique = "none";
        if (!rule.shadow.technique) rule.shadow.technique = "auto";
        level_.shadows.rules.push_back(std::move(rule));
    }
    if (auto drawn = studio_.draw(level_, camera_); !drawn) return drawn;
    if (studio_.shadows().unserved().empty()) return {};
    return engine::Error{why_unserved(studio_.shadows())};
}

engine::Result<chart::Point>
Charting::point(const std::string& word, std::size_t light, const truth::TruthImage& truth) {
    const ChartSetting setting = chart_setting(word);
    chart::Point point;
    point.name = word;
    point.series = setting.series;
    point.family = setting.family;
    point.budget_px = setting.budget_px;
    point.is_truth = setting.series == "traced";
    const gpu::Counters counters =
        added_by_shadows(studio_.renderer().frame().counters(), without_);
    point.predicted_ms =
        counted_ms(counters, studio_.shadows().plan(), truth.image.visibility.size());
    const DrawnSurfaces drawn = drawn_surfaces(studio_, camera_);
    const engine::Image color = studio_.color();
    const auto mask = studio_.mask(light);
    if (!mask) return mask.error();
    const measure::Comparison comparison =
        make_comparison(*mask, truth, drawn, camera_, lights_[light]);
    const measure::Figures figures = measure::compare(comparison);
    point.errors = errors_of(comparison, figures);
    if (point.budget_px)
        point.facts.emplace_back(
            "picked", Serving(studio_.shadows(), light).shares(drawn, comparison));
    add_facts(point, figures, counters, studio_.shadows().gpu_bytes());
    point.pictures = {url(color), url(*mask), url(error_image(comparison))};
    if (options_.timing.frames == 0) return point;
    const auto times = time_frames(
        studio_, options_.timing, [&](bool with) { return studio_.draw(level_, camera_, with); });
    if (!times) return times.error();
    point.measured_ms = times->with.median_ms - times->without.median_ms;
    point.facts.emplace_back("whole frame, ms", fmt::format("{:.4g}", times->with.median_ms));
    return point;
}

void Charting::refuse(chart::Chart& chart, const std::string& word, const std::string& reason) {
    const std::string series = chart_setting(word).series;
    for (chart::Refusal& refusal : chart.refusals)
        if (refusal.reason == reason && chart_setting(refusal.name).series == series) {
            refusal.name += ", " + word;
            return;
        }
    chart.refusals.push_back({word, reason});
}

engine::Result<chart::Chart>
Charting::of_light(std::size_t light, const trace::TraceScene& tracer) {
    chart::Chart chart;
    chart.scene = level_.name;
    chart.light = lights_[light].name;
    chart.soft = is_soft(lights_[light].light);
    truth::TruthOptions truth_options;
    truth_options.visibility.samples = options_.truth_samples;
    progress_(fmt::format("{}: truth", chart.title()));
    const truth::TruthImage truth =
        truth::true_visibility(tracer, camera_, lights_[light], truth_options);
    chart.truth_mask = url(truth::mask_picture(truth));
    for (const std::string& word : options_.words) {
        progress_(fmt::format("{}: {}", chart.title(), word));
        if (const auto drawn = draw(word, light); !drawn) {
            refuse(chart, word, drawn.error().message);
            continue;
        }
        auto point = this->point(word, light, truth);
        if (!point) return point.error();
        chart.points.push_back(*std::move(point));
    }
    return chart;
}

/// Settings that serve every light.
engine::Result<chart::Chart> Charting::of_all(const std::vector<chart::Chart>& of_lights) {
    chart::Chart all;
    all.scene = level_.name;
    for (const chart::Chart& one : of_lights)
        all.soft = all.soft || one.soft;
    for (const std::string& word : options_.words) {
        std::vector<const chart::Point*> parts;
        for (const chart::Chart& one : of_lights)
            for (const chart::Point& point : one.points)
                if (point.name == word) parts.push_back(&point);
        if (parts.size() < of_lights.size()) {
            refuse(all, word, "does not serve every light: see their charts");
            continue;
        }
        progress_(fmt::format("{}: {}", all.title(), word));
        chart::Point sum = *parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) {
            *sum.errors += *parts[i]->errors;
            *sum.predicted_ms += *parts[i]->predicted_ms;
            if (sum.measured_ms) *sum.measured_ms += *parts[i]->measured_ms;
        }
        sum.facts.clear();
        for (std::size_t i = 0; i < parts.size(); ++i)
            for (const auto& [name, text] : parts[i]->facts)
                if (name == "picked")
                    sum.facts.emplace_back(
                        fmt::format("picked for '{}'", of_lights[i].light), text);
        sum.pictures = {};
        if (const auto drawn = draw(word, {}); !drawn) return drawn.error();
        sum.pictures.color = url(studio_.color());
        all.points.push_back(std::move(sum));
    }
    return all;
}

engine::Result<std::vector<chart::Chart>> Charting::charts() {
    const auto charted = charted_lights(lights_, options_.light);
    if (!charted) return charted.error();
    width_ = picture_width(options_.words.size() * (1 + 3 * charted->size()), camera_);
    const trace::TraceScene tracer(level_.world);
    if (auto drawn = studio_.draw(level_, camera_, false); !drawn) return drawn.error();
    without_ = studio_.renderer().frame().counters();
    std::vector<chart::Chart> charts;
    for (const std::size_t light : *charted) {
        auto chart = of_light(light, tracer);
        if (!chart) return chart.error();
        charts.push_back(*std::move(chart));
    }
    if (charts.size() > 1) {
        auto all = of_all(charts);
        if (!all) return all.error();
        charts.insert(charts.begin(), *std::move(all));
    }
    progress_("");
    return charts;
}

} // namespace

engine::Result<std::vector<std::size_t>>
charted_lights(const std::vector<scene::PlacedLight>& lights, const std::string& name) {
    std::vector<std::size_t> charted;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        names.emplace_back(lights[i].name);
        if (name.empty() || name == lights[i].name) charted.push_back(i);
    }
    if (lights.empty())
        return engine::Error{"the scene has no light; expected one whose shadows can be charted"};
    if (charted.empty())
        return engine::Error{fmt::format(
            "--light {}: the scene has no such light{}", name, engine::did_you_mean(name, names))};
    return charted;
}

engine::Result<std::vector<chart::Chart>> chart_level(
    Studio& studio,
    Level& level,
    const scene::CameraView& camera,
    const ChartingOptions& options,
    const std::function<void(const std::string&)>& progress) {
    return Charting(studio, level, camera, options, progress).charts();
}

} // namespace gnomon
