#include "engine/trace/trace_scene.hpp"

#include "engine/trace/candidate_tree.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace trace {
namespace {

/// The tree's floats are wrong by at most 5 * 2^-24 of the scene's reach: the ray's origin by half
/// a unit in the last place, its direction likewise over a length of up to 3.5 reaches, bounds by
/// half a unit.
constexpr double kPad = 0x1p-20;
constexpr double kOffset = 1e-6;

/// What an entity's geometry was built from.
struct Versions {
    std::uint64_t instance = 0;
    std::uint64_t transform = 0;
    std::uint64_t pose = 0;

    bool operator==(const Versions&) const = default;
};

struct Entry {
    TracedEntity traced;
    Versions versions;
    bool found = false; ///< by the update at work
};

} // namespace

struct TraceScene::State {
    std::unique_ptr<CandidateTree> tree; ///< from the first update of a world with something in it
    std::map<ecs::Entity, std::unique_ptr<Entry>> entries;
    /// The world at the last update, and the versions of whole storages.
    std::array<std::uint64_t, 5> seen = {};
    glm::dvec3 origin = {};
    double reach = 0.0; ///< largest coordinate relative to the origin that the pads are made for
    engine::Box<glm::dvec3> bounds; ///< relative to the origin
    std::uint64_t builds = 0;

    void anchor(const engine::WorldAabb& world_bounds);
    bool refresh(const scene::World& world, ecs::Entity entity);
    bool drop_lost();
    void update_roles(const scene::World& world);
    void commit();
};

/// Moves the origin into the middle of the world when the pads made for the old one no longer suit.
void TraceScene::State::anchor(const engine::WorldAabb& world_bounds) {
    if (world_bounds.empty()) return;
    const glm::dvec3 farthest =
        glm::max(glm::abs(world_bounds.min - origin), glm::abs(world_bounds.max - origin));
    const double needed = std::max({farthest.x, farthest.y, farthest.z});
    const glm::dvec3 half = 0.5 * world_bounds.extent();
    const double least = std::max({half.x, half.y, half.z, 1e-3});
    if (needed <= reach && reach <= 16.0 * least) return;
    for (auto& [entity, entry] : entries)
        tree->detach(entry->traced);
    entries.clear();
    origin = world_bounds.centre();
    reach = 2.0 * least;
}

/// Builds an entity's geometry if it is new or changed; says whether it was.
bool TraceScene::State::refresh(const scene::World& world, ecs::Entity entity) {
    const ecs::Registry& registry = world.registry;
    const Versions versions = {
        registry.version<scene::MeshInstance>(entity),
        registry.version<scene::WorldTransform>(entity),
        registry.version<scene::PosedMesh>(entity)};
    std::unique_ptr<Entry>& entry = entries[entity];
    if (entry && entry->versions == versions) {
        entry->found = true;
        return false;
    }
    if (entry) tree->detach(entry->traced);
    entry = std::make_unique<Entry>();
    entry->traced.exact = exact_geometry(world, entity, origin);
    entry->traced.pad = kPad * reach;
    entry->versions = versions;
    entry->found = true;
    if (!entry->traced.exact.triangles.empty()) tree->attach(entry->traced);
    ++builds;
    return true;
}

/// Forgets entities that the update at work did not find.
bool TraceScene::State::drop_lost() {
    bool dropped = false;
    for (auto at = entries.begin(); at != entries.end();) {
        if (at->second->found) {
            at->second->found = false;
            ++at;
            continue;
        }
        tree->detach(at->second->traced);
        at = entries.erase(at);
        dropped = true;
    }
    return dropped;
}

void TraceScene::State::update_roles(const scene::World& world) {
    for (auto& [entity, entry] : entries) {
        const auto* role = world.registry.try_get<scene::ShadowRole>(entity);
        entry->traced.exact.casts = role == nullptr || role->casts;
        entry->traced.exact.receives = role == nullptr || role->receives;
    }
}

void TraceScene::State::commit() {
    bounds = {};
    for (const auto& [entity, entry] : entries)
        bounds.grow(entry->traced.exact.bounds);
    const double pad = kPad * reach;
    tree->commit({bounds.min - pad, bounds.max + pad});
}

TraceScene::TraceScene() : state_(std::make_unique<State>()) {}
TraceScene::~TraceScene() = default;
TraceScene::TraceScene(TraceScene&&) noexcept = default;
TraceScene& TraceScene::operator=(TraceScene&&) noexcept = default;

void TraceScene::update(const scene::World& world) {
    const ecs::Registry& registry = world.registry;
    if (world.identity.number() != state_->seen.front()) state_ = std::make_unique<State>();
    State& state = *state_;
    const std::array<std::uint64_t, 5> versions = {
        world.identity.number(),
        registry.version<scene::MeshInstance>(),
        registry.version<scene::WorldTransform>(),
        registry.version<scene::PosedMesh>(),
        registry.version<scene::ShadowRole>()};
    if (versions == state.seen) return;
    state.seen = versions;
    if (!state.tree) state.tree = std::make_unique<CandidateTree>();
    state.anchor(scene::world_bounds(world));

    bool changed = false;
    registry.each<scene::MeshInstance, scene::WorldTransform>(
        [&](ecs::Entity entity, const auto& /*instance*/, const auto& /*transform*/) {
            changed = state.refresh(world, entity) || changed;
        });
    changed = state.drop_lost() || changed;
    state.update_roles(world);
    if (changed) state.commit();
}

std::optional<Hit>
TraceScene::intersect(const glm::dvec3& origin, const glm::dvec3& direction, double t_max) const {
    if (!state_->tree) return std::nullopt;
    RayQuery query;
    query.origin = origin - state_->origin;
    query.direction = direction;
    query.t_max = t_max;
    query.primary = true;
    state_->tree->find_nearest(query);
    if (query.nearest == nullptr) return std::nullopt;

    const ExactGeometry& exact = query.nearest->exact;
    const ExactTriangle& triangle = exact.triangles[query.nearest_triangle];
    const Crossing& crossing = query.crossing;
    Hit hit;
    hit.position = origin + crossing.t * direction;
    hit.normal = exact.normal(query.nearest_triangle);
    if (glm::dot(hit.normal, direction) > 0.0) hit.normal = -hit.normal;
    hit.entity = exact.entity;
    hit.triangle = triangle.first_index;
    hit.patch_id = triangle.patch_id;
    hit.receives = exact.receives;
    hit.t = crossing.t;
    hit.barycentrics = {1.0 - crossing.u - crossing.v, crossing.u, crossing.v};
    return hit;
}

bool TraceScene::occluded(
    const Surface& from, const glm::dvec3& to_light, double t_max, double offset) const {
    if (!state_->tree) return false;
    RayQuery query;
    query.origin = from.position - state_->origin + offset * from.normal;
    query.direction = to_light;
    query.t_max = t_max;
    query.casters_only = true;
    query.skip_entity = from.entity;
    query.skip_triangle = from.triangle;
    return state_->tree->finds_any(query);
}

bool TraceScene::occluded(
    const glm::dvec3& origin, const glm::dvec3& direction, double distance) const {
    if (!state_->tree) return false;
    RayQuery query;
    query.origin = origin - state_->origin;
    query.direction = direction;
    query.t_max = distance / glm::length(direction);
    return state_->tree->finds_any(query);
}

double TraceScene::default_offset() const {
    return state_->bounds.empty() ? 0.0 : kOffset * glm::length(state_->bounds.extent());
}

engine::WorldAabb TraceScene::bounds() const {
    if (state_->bounds.empty()) return {};
    return {state_->bounds.min + state_->origin, state_->bounds.max + state_->origin};
}

std::size_t TraceScene::triangle_count() const {
    std::size_t count = 0;
    for (const auto& [entity, entry] : state_->entries)
        count += entry->traced.exact.triangles.size();
    return count;
}

std::uint64_t TraceScene::build_count() const {
    return state_->builds;
}

} // namespace trace
