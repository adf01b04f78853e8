// The committed texts are those that the schema makes. Run with GNOMON_UPDATE=1 to write them anew.

#include "engine/script/schema_documents.hpp"
#include "engine/script/text_file.hpp"
#include "tests/engine/script/levels.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace script {

namespace {

void expect_committed(const std::string& file, const std::string& text) {
    const std::filesystem::path path = std::filesystem::path(PROJECT_SOURCE_DIR) / file;
    if (std::getenv("GNOMON_UPDATE") != nullptr) std::ofstream(path) << text;
    const auto committed = read_text_file(path);
    ASSERT_TRUE(committed) << engine::to_string(committed.error());
    EXPECT_TRUE(*committed == text) << file << " is stale: run GNOMON_UPDATE=1 engine_script_tests";
}

TEST(SchemaDocuments, EditorAnnotationsAreFresh) {
    expect_committed("scripts/meta/gnomon.d.lua", lua_annotations(scene_schema(testing::words())));
}

TEST(SchemaDocuments, TheReferencePageIsFresh) {
    expect_committed("docs/reference.md", reference_page(scene_schema(testing::words())));
}

TEST(SchemaDocuments, EveryExampleLoads) {
    for (const engine::Kind& kind : scene_schema(testing::words()).kinds) {
        if (!kind.constructed) continue;
        SCOPED_TRACE(kind.name);
        const std::string others =
            kind.name == "rule"
                ? "g.spot { name = \"torch\" }, g.model { name = \"floor\", shape = \"box\" }, "
                : "";
        const std::string text = kind.name == "scene"
                                     ? "return " + kind.example
                                     : "return g.scene { " + others + kind.example + " }";
        const LoadedScene loaded = testing::load(text);
        EXPECT_TRUE(loaded.scene.has_value()) << loaded.error_text();
        EXPECT_TRUE(loaded.warnings.empty());
    }
}

TEST(SchemaDocuments, TheFuzzDictionaryHasEveryWord) {
    const auto dictionary = read_text_file(
        std::filesystem::path(PROJECT_SOURCE_DIR) / "tests/fuzz/corpus/lua/lua.dict");
    ASSERT_TRUE(dictionary) << engine::to_string(dictionary.error());
    const auto expect = [&](const std::string& line) {
        EXPECT_NE(dictionary->find("\n" + line + "\n"), std::string::npos) << line;
    };
    for (const engine::Kind& kind : scene_schema(testing::words()).kinds) {
        if (kind.constructed) expect("\"" + kind.name + "\"");
        for (const engine::Field& field : kind.fields) {
            expect("\"" + field.name + "\"");
            for (const std::string& word : field.words)
                expect("\"\\\"" + word + "\\\"\"");
        }
    }
}

TEST(Schema, EveryDefaultIsInItsRange) {
    for (const engine::Kind& kind : scene_schema(testing::words()).kinds) {
        for (const engine::Field& field : kind.fields) {
            SCOPED_TRACE(kind.name + "." + field.name);
            if (const auto* number = std::get_if<double>(&field.fallback)) {
                EXPECT_TRUE(field.range.contains(*number));
            }
            const auto* numbers = std::get_if<std::vector<double>>(&field.fallback);
            for (const double component : numbers != nullptr ? *numbers : std::vector<double>())
                EXPECT_TRUE(field.range.contains(component));
        }
    }
}

} // namespace

} // namespace script
