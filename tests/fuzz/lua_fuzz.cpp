// Any text as a level: it must load or be refused with a message, and act, soon and without a
// crash.

#include "engine/scene/scene_builder.hpp"
#include "engine/script/scene_loader.hpp"
#include "tests/engine/script/levels.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

/// One on_update. Model files are left out: a text must not choose what is opened.
void act(script::LoadedScene& loaded) {
    std::erase_if(loaded.scene->models, [](const scene::ModelDescription& model) {
        return !model.file.empty();
    });
    scene::World world;
    if (!scene::build_world(*loaded.scene, {}, world)) return;
    constexpr float kSeconds = 0.1F;
    // A mistake in it is a result like another.
    static_cast<void>(loaded.script->update(world, kSeconds));
    scene::update(world, kSeconds);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const script::SceneVocabulary words = script::testing::words();
    constexpr script::LuaLimits kSmall{
        .memory_bytes = 4U << 20U, .instructions = 20'000, .seconds = 1.0};
    const std::string_view text(
        reinterpret_cast<const char*>(data), size); // bytes are what they are
    script::LoadedScene loaded = script::load_scene_text(text, "fuzz.lua", words, kSmall);
    if (loaded.scene.has_value() != loaded.errors.empty()) std::abort();
    if (loaded.script) act(loaded);
    return 0;
}
