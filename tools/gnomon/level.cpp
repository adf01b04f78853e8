#include "tools/gnomon/level.hpp"

#include "engine/core/text.hpp"
#include "engine/scene/framing.hpp"
#include "engine/scene/scene_builder.hpp"
#include "engine/scene/views.hpp"
#include "engine/script/scene_loader.hpp"
#include "systems/shadows/technique_registry.hpp"

#include <fmt/format.h>

namespace gnomon {

namespace {

script::SceneVocabulary vocabulary() {
    const auto techniques = shadows::all_techniques();
    script::SceneVocabulary words;
    for (const auto& technique : techniques)
        words.techniques.emplace_back(technique->traits().name);
    return words;
}

engine::Result<void> build_from_lua(const std::filesystem::path& file, Level& level) {
    script::LoadedScene loaded = script::load_scene(file, vocabulary());
    for (const std::string& line : loaded.output)
        fmt::print("{}\n", line);
    if (!loaded.scene) return engine::Error{loaded.error_text()};
    const scene::SceneDescription& description = *loaded.scene;
    auto built = scene::build_world(description, file.parent_path(), level.world);
    if (!built) return built.error();
    level.warnings = std::move(loaded.warnings);
    level.warnings.insert(level.warnings.end(), built->begin(), built->end());
    level.shadows = shadows::ShadowSettings::from(description);
    level.exposure = description.exposure;
    level.player = description.player;
    level.script = std::move(loaded.script);
    return {};
}

engine::Result<void> build_from_gltf(const std::filesystem::path& file, Level& level) {
    auto built = scene::build_world_from_gltf(file, level.world);
    if (!built) return built.error();
    level.warnings = *std::move(built);
    return {};
}

} // namespace

engine::Result<Level> load_level(const std::filesystem::path& file) {
    const std::string kind = file.extension().string();
    if (kind != ".lua" && kind != ".glb" && kind != ".gltf")
        return engine::Error{"expected a scene that ends in .lua, .glb or .gltf", {file.string()}};
    Level level;
    level.file = file;
    level.name = file.stem().string();
    const auto built = kind == ".lua" ? build_from_lua(file, level) : build_from_gltf(file, level);
    if (!built) return built.error();
    scene::update(level.world, 0.0F);
    return level;
}

void advance(Level& level, float dt) {
    if (level.script) {
        const auto done = level.script->update(level.world, dt);
        for (const std::string& line : level.script->take_output())
            fmt::print("{}\n", line);
        if (!done) fmt::print(stderr, "{}\n", engine::to_string(done.error()));
    }
    scene::update(level.world, dt);
}

engine::Result<scene::CameraView>
choose_camera(const Level& level, const std::string& name, int width, int height) {
    if (auto found = scene::find_camera(level.world, name, width, height)) return *found;
    if (name.empty()) return scene::frame_scene(level.world, width, height);
    const auto names = scene::camera_names(level.world);
    const std::vector<std::string_view> views(names.begin(), names.end());
    return engine::Error{fmt::format(
        "no camera '{}'; expected one of: {}{}",
        name,
        fmt::join(names, ", "),
        engine::did_you_mean(name, views))};
}

void print_warnings(const Level& level) {
    for (const std::string& warning : level.warnings)
        fmt::print(stderr, "warning: {}\n", warning);
}

} // namespace gnomon
