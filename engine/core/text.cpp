#include "engine/core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace engine {

namespace {

/// Optimal string alignment distance. Source: Damerau 1964; Wagner and Fischer 1974.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + cost});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

/// How many letters two words share at their start, when those are most of the shorter one; else 0.
std::size_t shared_start(std::string_view a, std::string_view b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    const auto end =
        std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shorter), b.begin()).first;
    const auto shared = static_cast<std::size_t>(end - a.begin());
    return shared >= 3 && shared * 3 >= shorter * 2 ? shared : 0;
}

} // namespace

std::optional<std::string_view>
nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    std::optional<std::string_view> best;
    std::size_t best_distance = 0;
    for (const std::string_view candidate : candidates) {
        const std::size_t allowed =
            std::max<std::size_t>(1, std::max(word.size(), candidate.size()) / 3);
        const std::size_t distance = edit_distance(word, candidate);
        if (distance > allowed || (best && distance >= best_distance)) continue;
        best = candidate;
        best_distance = distance;
    }
    if (best) return best;
    std::size_t best_start = 0;
    for (const std::string_view candidate : candidates) {
        const std::size_t start = shared_start(word, candidate);
        if (start <= best_start) continue;
        best = candidate;
        best_start = start;
    }
    return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    const auto best = nearest_word(word, candidates);
    return best ? fmt::format("; did you mean '{}'?", *best) : std::string();
}

} // namespace engine
