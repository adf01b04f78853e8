#include "tools/gnomon/chart_settings.hpp"

#include "engine/scene/proxy.hpp"
#include "systems/shadows/planar_prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "tools/gnomon/view_options.hpp"

namespace gnomon {

namespace {

constexpr std::array kSizes = {256, 512, 1024, 2048, 4096};
constexpr std::array kQuickSizes = {512, 2048};
constexpr std::array kSamples = {4, 16, 64};
constexpr std::array kBudgetsPx = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
constexpr std::array kQuickBudgetsPx = {0.25, 1.0, 4.0};
constexpr std::string_view kMap = "map";
constexpr std::string_view kAuto = "auto";

bool is_map(std::string_view technique) {
    ShadowOptions options;
    options.technique = kMap;
    const std::array kinds = {
        scene::LightKind::directional, scene::LightKind::spot, scene::LightKind::point};
    return std::any_of(kinds.begin(), kinds.end(), [&](scene::LightKind kind) {
        return options.wish(kind).technique == technique;
    });
}

std::vector<int> sizes(bool quick) {
    return quick ? std::vector<int>(kQuickSizes.begin(), kQuickSizes.end())
                 : std::vector<int>(kSizes.begin(), kSizes.end());
}

std::vector<std::string> maps(bool soft, bool quick) {
    std::vector<std::string_view> filters = {"pcf"};
    if (!quick) filters = {"nearest", "bilinear", "pcf"};
    if (soft) filters.emplace_back("pcss");
    std::vector<std::string> words;
    for (const std::string_view filter : filters)
        for (const int size : sizes(quick))
            words.push_back(fmt::format("{}@{}:{}", kMap, size, filter));
    return words;
}

/// Samples first, then ways: "planar", "planar@16", "planar:box", "planar@16:box".
std::vector<std::string> planars(bool soft, bool quick) {
    std::vector<std::string> words = {"planar"};
    std::vector<std::string> numbers = {""};
    if (soft) {
        numbers.clear();
        for (const int samples : kSamples)
            numbers.push_back(fmt::format("@{}", samples));
        for (const std::string& number : numbers)
            words.push_back("planar" + number);
    }
    if (quick) return words;
    for (const std::string_view way : shadows::kPlanarWays)
        for (const std::string& number : numbers)
            words.push_back(fmt::format("planar{}:{}", number, way));
    return words;
}

std::vector<std::string> words_of(std::string_view technique, bool soft, bool quick) {
    std::vector<std::string> words;
    if (technique == kMap) return maps(soft, quick);
    if (technique == "planar") return planars(soft, quick);
    if (technique == "shadow_texture")
        for (const int size : sizes(quick))
            words.push_back(fmt::format("{}@{}", technique, size));
    if (technique == "volume")
        for (std::size_t level = 0; level <= (quick ? 0 : scene::kProxyLevels); ++level)
            words.push_back(fmt::format("{}@{}", technique, level));
    if (technique == kAuto)
        for (const double budget :
             quick ? std::vector<double>(kQuickBudgetsPx.begin(), kQuickBudgetsPx.end())
                   : std::vector<double>(kBudgetsPx.begin(), kBudgetsPx.end()))
            words.push_back(fmt::format("{}@{:g}", technique, budget));
    if (words.empty()) words.emplace_back(technique);
    return words;
}

} // namespace

ChartSetting chart_setting(const std::string& word) {
    ChartSetting setting;
    setting.word = word;
    setting.series = word.substr(0, word.find_first_of("@:%"));
    if (setting.series == kAuto) {
        const std::size_t at = word.find('@');
        if (at != std::string::npos)
            setting.budget_px = std::strtod(word.c_str() + at + 1, nullptr);
        return setting;
    }
    const std::size_t at = word.find('@');
    if (at == std::string::npos) return setting;
    std::size_t end = at + 1;
    while (end < word.size() && std::isdigit(static_cast<unsigned char>(word[end])) != 0)
        ++end;
    setting.family = word.substr(0, at) + word.substr(end);
    return setting;
}

std::vector<std::string>
settings_to_try(const shadows::Techniques& techniques, bool soft, bool quick) {
    std::vector<std::string> words;
    for (const std::string& series : chart_series(techniques))
        for (std::string& word : words_of(series, soft, quick))
            words.push_back(std::move(word));
    return words;
}

std::vector<std::string> chart_series(const shadows::Techniques& techniques) {
    std::vector<std::string> series;
    for (const auto& technique : techniques) {
        const std::string_view name = technique->traits().name;
        series.emplace_back(is_map(name) ? kMap : name);
    }
    // The maps of all kinds are one.
    for (auto one = series.begin(); one != series.end(); ++one)
        series.erase(std::remove(one + 1, series.end(), *one), series.end());
    series.emplace_back(kAuto);
    return series;
}

} // namespace gnomon
