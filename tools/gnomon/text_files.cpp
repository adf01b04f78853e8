#include "tools/gnomon/text_files.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>

namespace gnomon {

engine::Result<void> make_folder(const std::filesystem::path& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem)
        return engine::Error{
            fmt::format("could not be made: {}", problem.message()), {folder.string()}};
    return {};
}

engine::Result<void> write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        return engine::Error{"could not be written; expected a folder with room", {file.string()}};
    return {};
}

std::string file_word(const std::string& name) {
    std::string word = name;
    for (char& letter : word)
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-' && letter != '.')
            letter = '_';
    return word;
}

} // namespace gnomon
