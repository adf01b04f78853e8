// Any text as a level: it must load or be refused with a message, soon and without a crash.

#include "engine/script/scene_loader.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const script::SceneVocabulary words{{"none", "blob", "planar", "volume", "spot_map"}};
    constexpr script::LuaLimits kSmall{
        .memory_bytes = 4U << 20U, .instructions = 20'000, .seconds = 1.0};
    const std::string_view text(
        reinterpret_cast<const char*>(data), size); // bytes are what they are
    const script::LoadedScene loaded = script::load_scene_text(text, "fuzz.lua", words, kSmall);
    if (loaded.scene.has_value() != loaded.errors.empty()) std::abort();
    return 0;
}
