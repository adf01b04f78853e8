#include "systems/shadows/plan_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <unordered_map>

namespace shadows {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) {
    return std::round(value * 1024.0) / 1024.0;
}

/// Names by id, for the whole file.
struct Names {
    std::unordered_map<std::uint32_t, const std::string*> lights;
    std::unordered_map<std::uint32_t, const std::string*> receivers;

    explicit Names(const ShadowScene& scene) {
        for (const LightView& light : scene.lights)
            lights.emplace(light.id, &light.name);
        for (const ReceiverView& receiver : scene.receivers)
            receivers.emplace(receiver.id, &receiver.name);
    }
};

Json to_json(const Prediction& predicted) {
    return {
        {"error_px", rounded(predicted.error_px)},
        {"error_area_px", rounded(predicted.error_area_px)}};
}

Json to_json(const Names& names, const Plan& plan) {
    Json json;
    json["light"] = *names.lights.at(plan.light);
    json["receiver"] = *names.receivers.at(plan.receiver);
    json["budget_px"] = rounded(plan.budget_px);
    json["reason"] = plan.reason;
    json["entries"] = Json::array();
    for (const PlanEntry& entry : plan.entries) {
        Json part = {{"technique", entry.technique}, {"caster_groups", entry.caster_groups}};
        part["predicted"] = to_json(entry.predicted);
        json["entries"].push_back(std::move(part));
    }
    json["rejected"] = Json::array();
    for (const Rejection& rejection : plan.rejected) {
        Json part = {{"technique", rejection.technique}, {"reason", rejection.reason}};
        if (rejection.predicted) part["predicted"] = to_json(*rejection.predicted);
        json["rejected"].push_back(std::move(part));
    }
    return json;
}

Json to_json(const ShadowScene& scene, const Names& names, const FramePlan::LightGroups& light) {
    Json groups = Json::array();
    for (const CasterGroup& group : light.groups) {
        Json casters = Json::array();
        for (const std::uint32_t index : group.casters)
            casters.push_back(scene.casters[index].name);
        groups.push_back({{"hero", group.hero}, {"casters", std::move(casters)}});
    }
    return {{"light", *names.lights.at(light.light)}, {"groups", std::move(groups)}};
}

} // namespace

std::string plans_to_json(const ShadowScene& scene, const FramePlan& plan) {
    const Names names(scene);
    Json json;
    json["caster_groups"] = Json::array();
    for (const FramePlan::LightGroups& light : plan.groups)
        json["caster_groups"].push_back(to_json(scene, names, light));
    json["pairs"] = Json::array();
    for (const Plan& pair : plan.plans)
        json["pairs"].push_back(to_json(names, pair));
    return json.dump(1) + "\n";
}

} // namespace shadows
