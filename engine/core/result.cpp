#include "engine/core/result.hpp"

#include <fmt/format.h>

namespace engine {

std::string to_string(const Error& error) {
    const auto& [message, place] = error;
    if (place.file.empty()) return message;
    if (place.line == 0) return fmt::format("{}: {}", place.file, message);
    return fmt::format("{}:{}: {}", place.file, place.line, message);
}

} // namespace engine
