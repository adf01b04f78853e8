// Whatever a level says, it is either a scene or a list of mistakes, soon, and every time the same.

#include "engine/core/random.hpp"
#include "engine/script/text_file.hpp"
#include "tests/engine/script/levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace script {

namespace {

const LuaLimits kSmall{.memory_bytes = 8U << 20U, .instructions = 20'000, .seconds = 1000.0};

/// The texts that the fuzzer starts from.
std::vector<std::string> seeds() {
    std::set<std::filesystem::path> files;
    const std::filesystem::path folder =
        std::filesystem::path(PROJECT_SOURCE_DIR) / "tests/fuzz/corpus/lua";
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".lua") files.insert(entry.path());
    std::vector<std::string> texts;
    for (const std::filesystem::path& file : files)
        texts.push_back(*read_text_file(file));
    return texts;
}

/// A piece of one text put over, into or out of another.
std::string mutated(std::string text, const std::string& other, engine::Random& random) {
    const auto place = [&](const std::string& in) {
        return random.below(static_cast<std::uint32_t>(in.size()) + 1U);
    };
    const std::size_t at = place(text);
    const std::size_t from = place(other);
    const std::string piece = other.substr(from, random.below(12));
    switch (random.below(3)) {
    case 0:
        return text.insert(at, piece);
    case 1:
        return text.erase(at, piece.size());
    default:
        return text.replace(at, piece.size(), piece);
    }
}

TEST(RandomLevels, AreScenesOrListsOfMistakes) {
    const std::vector<std::string> texts = seeds();
    ASSERT_GE(texts.size(), 5U);
    engine::Random random(7);
    for (int round = 0; round < 400; ++round) {
        std::string text = texts[random.below(static_cast<std::uint32_t>(texts.size()))];
        for (std::uint32_t edits = 1 + random.below(3); edits > 0; --edits)
            text = mutated(
                text, texts[random.below(static_cast<std::uint32_t>(texts.size()))], random);
        SCOPED_TRACE(text);

        const LoadedScene once = load_scene_text(text, "random.lua", testing::words(), kSmall);
        const LoadedScene again = load_scene_text(text, "random.lua", testing::words(), kSmall);

        EXPECT_EQ(once.scene.has_value(), once.errors.empty());
        EXPECT_EQ(once.error_text(), again.error_text());
        EXPECT_EQ(once.output, again.output);
        for (const engine::Error& error : once.errors) {
            EXPECT_EQ(error.place.file, "random.lua");
            EXPECT_LE(error.place.line, std::count(text.begin(), text.end(), '\n') + 1);
        }
    }
}

} // namespace

} // namespace script
