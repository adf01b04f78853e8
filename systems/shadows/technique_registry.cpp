#include "systems/shadows/technique_registry.hpp"

namespace shadows {

#define SHADOW_TECHNIQUE(name) std::unique_ptr<ShadowTechnique> make_##name();
#include "systems/shadows/techniques.def"
#undef SHADOW_TECHNIQUE

Techniques all_techniques() {
    Techniques techniques;
#define SHADOW_TECHNIQUE(name) techniques.push_back(make_##name());
#include "systems/shadows/techniques.def"
#undef SHADOW_TECHNIQUE
    return techniques;
}

const ShadowTechnique* find_technique(const Techniques& techniques, std::string_view name) {
    for (const auto& technique : techniques)
        if (technique->traits().name == name) return technique.get();
    return nullptr;
}

std::vector<std::string_view> technique_words(const Techniques& techniques) {
    std::vector<std::string_view> words = {"auto"};
    for (const auto& technique : techniques)
        words.push_back(technique->traits().name);
    return words;
}

} // namespace shadows
