// Words that people type, and the words they meant.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace engine {

/// The candidate with the fewest edits (insert, delete, replace, swap of neighbours) from `word`,
/// when they are few enough to be a slip: at most a third of the longer word, at least one. Else
/// the one that starts alike, when that is most of the shorter word ("pos" for "position"). Ties go
/// to the first.
std::optional<std::string_view>
nearest_word(std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean 'radius'?" or nothing: the end of an error message.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

} // namespace engine
