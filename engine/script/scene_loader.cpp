#include "engine/script/scene_loader.hpp"

#include "engine/script/presets.hpp"
#include "engine/script/report.hpp"
#include "engine/script/scene_reader.hpp"
#include "engine/script/text_file.hpp"
#include "engine/script/value.hpp"
#include "engine/script/vocabulary.hpp"

#include <fmt/format.h>

namespace script {

namespace {

namespace fs = std::filesystem;

/// Runs the level and reads what it returned.
scene::SceneDescription
run(LevelScript& script, std::string_view text, const std::string& name, Report& report) {
    LuaState& state = script.state();
    const Vocabulary& vocabulary = script.vocabulary();
    engine::Result<void> done = state.load(text, name);
    if (done) done = state.call(0, 1);
    engine::Result<Value> value =
        done ? vocabulary.copy_result() : engine::Result<Value>(done.error());
    if (value) value = filled_by_preset(*value, state, vocabulary);
    for (const engine::Error& mistake : vocabulary.mistakes())
        report.error(mistake);
    if (!value) {
        engine::Error error = value.error();
        if (error.place.file.empty()) error.place.file = name;
        report.error(error);
        return {};
    }
    return read_scene(*value, vocabulary.constructed(), script.schema(), name, report);
}

void check_model_files(
    const scene::SceneDescription& scene, const fs::path& folder, Report& report) {
    for (const scene::ModelDescription& model : scene.models) {
        if (model.file.empty()) continue;
        const fs::path file = folder / model.file;
        std::error_code failed;
        if (fs::is_regular_file(file, failed)) continue;
        const Subject subject{fmt::format("model \"{}\"", model.name), "model", model.place, {}};
        report.error(
            subject,
            "file",
            fmt::format("is \"{}\", but there is no file {}", model.file, file.generic_string()));
    }
}

LoadedScene load(
    std::unique_ptr<LevelScript> script,
    std::string_view text,
    const std::string& name,
    const fs::path* folder) {
    LuaState& state = script->state();
    Report report(state.sources());
    scene::SceneDescription scene = run(*script, text, name, report);
    if (folder != nullptr) check_model_files(scene, *folder, report);

    LoadedScene loaded;
    loaded.errors = report.errors();
    loaded.warnings = report.warnings();
    loaded.files = state.files();
    loaded.output = script->take_output();
    if (!loaded.errors.empty()) return loaded;
    scene.warnings = loaded.warnings;
    loaded.scene = std::move(scene);
    if (script->keep_update()) loaded.script = std::move(script);
    return loaded;
}

} // namespace

std::string LoadedScene::error_text() const {
    std::string text;
    for (const engine::Error& error : errors)
        text += engine::to_string(error) + "\n";
    return text;
}

LoadedScene
load_scene(const fs::path& file, const SceneVocabulary& vocabulary, const LuaLimits& limits) {
    const auto text = read_text_file(file);
    if (!text) {
        LoadedScene failed;
        failed.errors.push_back(text.error());
        failed.files.push_back(file);
        return failed;
    }
    auto script = std::make_unique<LevelScript>(vocabulary, limits);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    script->state().allow_modules(folder);
    script->state().add_file(file);
    return load(std::move(script), *text, file.generic_string(), &folder);
}

LoadedScene load_scene_text(
    std::string_view text,
    const std::string& name,
    const SceneVocabulary& vocabulary,
    const LuaLimits& limits) {
    auto script = std::make_unique<LevelScript>(vocabulary, limits);
    script->state().allow_modules();
    return load(std::move(script), text, name, nullptr);
}

} // namespace script
