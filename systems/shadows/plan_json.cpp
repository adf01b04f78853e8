#include "systems/shadows/plan_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace shadows {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) {
    return std::round(value * 1024.0) / 1024.0;
}

Json to_json(const Prediction& predicted) {
    return {
        {"error_px", rounded(predicted.error_px)},
        {"error_area_px", rounded(predicted.error_area_px)}};
}

Json to_json(const ShadowScene& scene, const Plan& plan) {
    Json json;
    json["light"] = scene.light(plan.light).name;
    json["receiver"] = scene.receiver(plan.receiver).name;
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

Json to_json(const ShadowScene& scene, const FramePlan::LightGroups& light) {
    Json groups = Json::array();
    for (const CasterGroup& group : light.groups) {
        Json casters = Json::array();
        for (const std::uint32_t index : group.casters)
            casters.push_back(scene.casters[index].name);
        groups.push_back({{"hero", group.hero}, {"casters", std::move(casters)}});
    }
    return {{"light", scene.light(light.light).name}, {"groups", std::move(groups)}};
}

} // namespace

std::string plans_to_json(const ShadowScene& scene, const FramePlan& plan) {
    Json json;
    json["caster_groups"] = Json::array();
    for (const FramePlan::LightGroups& light : plan.groups)
        json["caster_groups"].push_back(to_json(scene, light));
    json["pairs"] = Json::array();
    for (const Plan& pair : plan.plans)
        json["pairs"].push_back(to_json(scene, pair));
    return json.dump(1) + "\n";
}

} // namespace shadows
