// What a chart tries: every technique with the settings that it has.

#pragma once

#include "systems/shadows/shadow_technique.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gnomon {

/// One point to be.
struct ChartSetting {
    std::string word;                ///< as options_from_word() reads it
    std::string series;              ///< the word's technique
    std::string family;              ///< what differs in size alone; empty for what stands alone
    std::optional<double> budget_px; ///< of auto: the error that it is allowed
};

/// @param word one that options_from_word() reads
ChartSetting chart_setting(const std::string& word);

/// Map and texture sizes from 256 to 4096, every filter, proxy level and way, light samples where a
/// light is soft, and auto with budgets from 0.1 to 8 px. Techniques that are the map of one kind
/// of light are tried together, as "map".
/// @param quick two sizes, one filter, three budgets
std::vector<std::string>
settings_to_try(const shadows::Techniques& techniques, bool soft, bool quick);

/// Series in the order of their marks, whatever is tried.
std::vector<std::string> chart_series(const shadows::Techniques& techniques);

} // namespace gnomon
