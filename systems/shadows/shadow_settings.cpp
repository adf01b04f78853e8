#include "systems/shadows/shadow_settings.hpp"

namespace shadows {

namespace {

template <class T>
void overlay(std::optional<T>& below, const std::optional<T>& above) {
    if (above) below = above;
}

void overlay(scene::ShadowWish& below, const scene::ShadowWish& above) {
    overlay(below.technique, above.technique);
    overlay(below.never, above.never);
    overlay(below.error_px, above.error_px);
    overlay(below.map_size, above.map_size);
    overlay(below.filter, above.filter);
    overlay(below.samples, above.samples);
    overlay(below.cascades, above.cascades);
    overlay(below.proxy, above.proxy);
    overlay(below.way, above.way);
    overlay(below.refresh, above.refresh);
}

/// "hero/arm#2" belongs to the model "hero", and to "hero/arm".
bool belongs_to(std::string_view receiver, std::string_view model) {
    if (!receiver.starts_with(model)) return false;
    return receiver.size() == model.size() || receiver[model.size()] == '/'
           || receiver[model.size()] == '#';
}

} // namespace

ShadowSettings ShadowSettings::from(const scene::SceneDescription& description) {
    ShadowSettings settings;
    settings.scene = description.shadow;
    for (const scene::LightDescription& light : description.lights)
        settings.lights[light.name] = light.shadow;
    for (const scene::ModelDescription& model : description.models)
        settings.receivers[model.name] = model.shadow;
    settings.rules = description.rules;
    return settings;
}

scene::ShadowWish ShadowSettings::resolve(
    const scene::PlacedLight& light, std::string_view receiver, double distance) const {
    scene::ShadowWish wish = scene;
    if (const auto found = lights.find(light.name); found != lights.end())
        overlay(wish, found->second);
    for (const auto& [name, of_receiver] : receivers)
        if (belongs_to(receiver, name)) overlay(wish, of_receiver);
    for (const scene::RuleDescription& rule : rules) {
        const bool applies = (!rule.light || *rule.light == light.name)
                             && (!rule.receiver || belongs_to(receiver, *rule.receiver))
                             && (!rule.distance || distance >= static_cast<double>(*rule.distance));
        if (applies) overlay(wish, rule.shadow);
    }
    if (const auto found = overriding.find(light.light.kind); found != overriding.end())
        overlay(wish, found->second);
    return wish;
}

} // namespace shadows
