#include "systems/shadows/planar_casters.hpp"

#include "systems/shadows/light_samples.hpp"
#include "systems/shadows/planar_prediction.hpp"

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// Without a remedy everything is drawn anywhere, but for the receiver's own mesh.
bool unclipped(const Remedies& remedies) {
    return !remedies.on(Remedy::planar_stencil) || !remedies.on(Remedy::planar_anti_shadow_clip)
           || !remedies.on(Remedy::planar_behind_clip);
}

int most_samples(const PlanEntry& entry) {
    int count = 1;
    for (const Variant& variant : entry.variants)
        count = std::max(count, static_cast<int>(variant.samples));
    return count;
}

int sample_count(const PlanEntry& entry, const Remedies& remedies) {
    if (draws_plateau(entry, remedies)) return 1;
    const int count = most_samples(entry);
    return remedies.on(Remedy::planar_enough_samples) ? count : std::min(count, kFewestSamples);
}

/// Which of a mesh's box sets a way means.
std::optional<std::size_t> box_set(std::string_view way) {
    if (way == planar_way::kBox) return 0;
    if (way == planar_way::kBoxes) return 1;
    return std::nullopt;
}

/// What a light gives to a plane that it lights, up to a factor that all points of it share.
double gives(const PlanarSample& sample) {
    if (sample.light.light.kind == scene::LightKind::directional)
        return -glm::dot(sample.plane.normal, glm::dvec3(sample.light.direction));
    return sample.plane.light_height;
}

/// The middle of the hard shadow; that of the receiver where there is none.
glm::dvec3 shadow_centre(
    const ShadowScene& scene,
    const LightView& light,
    const ReceiverView& receiver,
    const LitPlane& plane,
    std::span<const CasterGroup> groups,
    const PlanEntry& entry) {
    engine::WorldAabb bounds;
    for (const std::uint32_t group : entry.caster_groups)
        for (const std::uint32_t index : groups[group].casters)
            bounds.grow(shadow_bounds(light, plane, receiver, scene.casters[index].bounds));
    return bounds.empty() ? receiver.bounds.centre() : bounds.centre();
}

/// A plane for each corner of the light, or for its centre alone; none where a part of the light is
/// below the horizon.
std::vector<PlanarSample> outline(
    const LightView& light,
    const ReceiverView& receiver,
    const glm::dvec3& seen_from,
    bool soft,
    const glm::dvec3& origin) {
    const std::vector<LightView> corners =
        soft ? light_outline(light, seen_from) : std::vector{light};
    std::vector<PlanarSample> samples;
    for (const LightView& corner : corners) {
        const auto plane = lit_plane(corner, receiver, origin);
        if (!plane) return {};
        samples.push_back({corner, *plane, 1.0});
    }
    return samples;
}

} // namespace

bool draws_plateau(const PlanEntry& entry, const Remedies& remedies) {
    const bool wished =
        std::any_of(entry.variants.begin(), entry.variants.end(), [](const Variant& variant) {
            return variant.way == planar_way::kPlateau;
        });
    return wished && (most_samples(entry) == 1 || !remedies.on(Remedy::planar_plateau_budget));
}

std::vector<PlanarSample> planar_samples(
    const LightView& light,
    const ReceiverView& receiver,
    const glm::dvec3& seen_from,
    int count,
    const glm::dvec3& origin,
    const Remedies& remedies) {
    const auto centre = lit_plane(light, receiver, origin);
    if (!centre) return {};
    if (count == 1) return {{light, *centre, 1.0}};
    const bool weighed = remedies.on(Remedy::planar_light_horizon);
    std::vector<PlanarSample> samples;
    double sum = 0.0;
    for (const LightView& point :
         light_samples(light, seen_from, count, SamplePattern::hammersley)) {
        const auto plane = lit_plane(point, receiver, origin);
        if (!plane || glm::dot(plane->normal, centre->normal) < 0.0) continue;
        samples.push_back({point, *plane, 1.0});
        if (weighed) samples.back().weight = gives(samples.back());
        sum += samples.back().weight;
    }
    // Without the remedy what is below the horizon counts as light that arrives.
    const double whole = weighed ? sum : static_cast<double>(count);
    for (PlanarSample& sample : samples)
        sample.weight /= whole;
    return samples;
}

std::optional<PlanarCasters> planar_casters(
    const ShadowScene& scene,
    const LightView& light,
    const ReceiverView& receiver,
    std::span<const CasterGroup> groups,
    const PlanEntry& entry,
    const glm::dvec3& origin,
    const Remedies& remedies) {
    const auto plane = lit_plane(light, receiver, origin);
    if (!plane) return std::nullopt;
    const int count = sample_count(entry, remedies);
    const glm::dvec3 seen_from = shadow_centre(scene, light, receiver, *plane, groups, entry);
    PlanarCasters casters{receiver.id, *plane, {}, {}, {}, {}};
    const bool soft = count > 1 || draws_plateau(entry, remedies);
    const std::vector<PlanarSample> corners = outline(light, receiver, seen_from, soft, origin);
    for (std::size_t i = 0; i < entry.caster_groups.size(); ++i)
        for (const std::uint32_t index : groups[entry.caster_groups[i]].casters) {
            const CasterView& caster = scene.casters[index];
            engine::WorldAabb bounds;
            for (const PlanarSample& corner : corners)
                bounds.grow(shadow_bounds(corner.light, corner.plane, receiver, caster.bounds));
            // Nothing ends the shadows of a light that is cut by the plane.
            const bool endless = corners.empty() || unclipped(remedies);
            if (endless && caster.id != receiver.entity) bounds = receiver.bounds;
            if (bounds.empty()) continue;
            casters.bounds.grow(bounds);
            const auto set = remedies.on(Remedy::planar_box_budget)
                                 ? box_set(entry.variants.at(i).way)
                                 : std::optional<std::size_t>(0);
            if (set && std::isfinite(caster.box_deviation[*set]) && caster.id != receiver.entity)
                casters.boxed.push_back({caster.mesh, *set, caster.world_from_mesh});
            else
                casters.entities.push_back(caster.id);
        }
    if (casters.entities.empty() && casters.boxed.empty()) return std::nullopt;
    casters.samples = planar_samples(light, receiver, seen_from, count, origin, remedies);
    return casters;
}

} // namespace shadows
