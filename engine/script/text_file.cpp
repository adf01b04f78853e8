#include "engine/script/text_file.hpp"

#include <fstream>
#include <iterator>

namespace script {

engine::Result<std::string> read_text_file(const std::filesystem::path& file) {
    constexpr std::uintmax_t kMaxBytes = 4U << 20U;
    const engine::SourcePlace place{file.generic_string(), 0};
    std::error_code failed;
    if (!std::filesystem::exists(file, failed)) return engine::Error{"no such file", place};
    if (!std::filesystem::is_regular_file(file, failed))
        return engine::Error{"this is not a file", place};
    if (std::filesystem::file_size(file, failed) > kMaxBytes || failed)
        return engine::Error{"this file is too large for a script: more than 4 MiB", place};
    std::ifstream stream(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream) return engine::Error{"this file cannot be read", place};
    return text;
}

} // namespace script
