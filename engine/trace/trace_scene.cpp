#include "engine/trace/trace_scene.hpp"

#include "engine/core/check.hpp"
#include "engine/trace/exact_geometry.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <type_traits>

namespace trace {
namespace {

using LocalBox = engine::Box<glm::dvec3>; ///< world axes, relative to the scene's origin

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Tree = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

/// Floats in the tree are wrong by at most 5 * 2^-24 of the scene's reach: the ray's origin by half
/// a unit in the last place, its direction likewise over a length of up to 3.5 reaches, bounds by
/// half a unit.
constexpr double kPad = 0x1p-20;

/// What an entity's geometry was built from.
struct Versions {
    std::uint64_t instance = 0;
    std::uint64_t transform = 0;
    std::uint64_t pose = 0;

    bool operator==(const Versions&) const = default;
};

struct Entry {
    ExactGeometry exact;
    Versions versions;
    double pad = 0.0; ///< metres
    unsigned int id = RTC_INVALID_GEOMETRY_ID;
    bool found = false; ///< by the update at work
};

/// A ray on its way through the tree. The callbacks know only this and the entry; t counts on the
/// exact ray.
struct Query {
    RTCIntersectContext context = {}; ///< first: Embree hands out a pointer to it
    glm::dvec3 origin = {};           ///< relative to the scene's origin
    glm::dvec3 direction = {};
    double t_min = 0.0;
    double t_max = kInfinity;
    double t_entry = 0.0; ///< where Embree's ray starts on the exact one
    bool primary = false; ///< back faces of single-sided materials are not there
    bool casters_only = false;
    ecs::Entity skip_entity;
    std::uint32_t skip_triangle = kNoTriangle;

    const Entry* nearest = nullptr;
    std::uint32_t nearest_triangle = 0;
    Crossing crossing = {};
};
static_assert(std::is_standard_layout_v<Query>);

/// The crossing of a query with a triangle, when there is one that counts.
std::optional<Crossing>
crossing_of(const Query& query, const Entry& entry, std::uint32_t triangle) {
    const ExactGeometry& exact = entry.exact;
    const ExactTriangle& at = exact.triangles[triangle];
    if (query.casters_only && !exact.casts) return std::nullopt;
    if (exact.entity == query.skip_entity && at.first_index == query.skip_triangle)
        return std::nullopt;
    const auto crossing = exact.cross(triangle, query.origin, query.direction);
    if (!crossing || crossing->t < query.t_min || crossing->t > query.t_max) return std::nullopt;
    if (query.primary && !at.double_sided
        && glm::dot(exact.normal(triangle), query.direction) > 0.0)
        return std::nullopt;
    if (exact.hole_at(triangle, *crossing)) return std::nullopt;
    return crossing;
}

/// Equal distances go to the lower entity and triangle, so that answers do not depend on the tree's
/// order.
bool nearer(
    const Query& query, const Crossing& crossing, const Entry& entry, std::uint32_t triangle) {
    if (query.nearest == nullptr || crossing.t != query.crossing.t)
        return query.nearest == nullptr || crossing.t < query.crossing.t;
    if (entry.exact.entity != query.nearest->exact.entity)
        return entry.exact.entity < query.nearest->exact.entity;
    return triangle < query.nearest_triangle;
}

void bounds_callback(const RTCBoundsFunctionArguments* arguments) {
    const auto& entry = *static_cast<const Entry*>(arguments->geometryUserPtr);
    const LocalBox box = entry.exact.triangle_bounds(arguments->primID);
    RTCBounds& out = *arguments->bounds_o;
    out.lower_x = static_cast<float>(box.min.x - entry.pad);
    out.lower_y = static_cast<float>(box.min.y - entry.pad);
    out.lower_z = static_cast<float>(box.min.z - entry.pad);
    out.upper_x = static_cast<float>(box.max.x + entry.pad);
    out.upper_y = static_cast<float>(box.max.y + entry.pad);
    out.upper_z = static_cast<float>(box.max.z + entry.pad);
}

void intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    const auto& entry = *static_cast<const Entry*>(arguments->geometryUserPtr);
    auto& query = *reinterpret_cast<Query*>(arguments->context);
    const auto crossing = crossing_of(query, entry, arguments->primID);
    if (!crossing || !nearer(query, *crossing, entry, arguments->primID)) return;
    query.nearest = &entry;
    query.nearest_triangle = arguments->primID;
    query.crossing = *crossing;
    // A little farther than exact: the tree must still propose whatever lies at the same distance.
    const double farther =
        (crossing->t - query.t_entry) * (1.0 + 1e-6) + entry.pad / glm::length(query.direction);
    RTCRayN* ray = RTCRayHitN_RayN(arguments->rayhit, 1);
    RTCRayN_tfar(ray, 1, 0) = std::min(RTCRayN_tfar(ray, 1, 0), static_cast<float>(farther));
}

void occluded_callback(const RTCOccludedFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    const auto& entry = *static_cast<const Entry*>(arguments->geometryUserPtr);
    const auto& query = *reinterpret_cast<const Query*>(arguments->context);
    if (crossing_of(query, entry, arguments->primID))
        RTCRayN_tfar(arguments->ray, 1, 0) = -std::numeric_limits<float>::infinity();
}

/// Cuts [t_min, t_max] down to what lies in the box; false when nothing does.
/// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986.
bool clip(
    const LocalBox& box,
    const glm::dvec3& origin,
    const glm::dvec3& direction,
    double& t_min,
    double& t_max) {
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return false;
            continue;
        }
        const double a = (box.min[axis] - origin[axis]) / direction[axis];
        const double b = (box.max[axis] - origin[axis]) / direction[axis];
        t_min = std::max(t_min, std::min(a, b));
        t_max = std::min(t_max, std::max(a, b));
    }
    return t_min <= t_max;
}

} // namespace

struct TraceScene::State {
    Device device;
    Tree tree;
    std::map<ecs::Entity, std::unique_ptr<Entry>> entries;
    std::array<std::uint64_t, 4> seen = {}; ///< versions of whole storages at the last update
    std::uint64_t seen_roles = 0;
    glm::dvec3 origin = {};
    double reach = 0.0; ///< largest coordinate relative to the origin that pads are made for; 0:
                        ///< not anchored yet
    LocalBox bounds;
    std::uint64_t builds = 0;

    void start();
    void anchor(const engine::WorldAabb& world_bounds);
    bool refresh(const scene::World& world, ecs::Entity entity);
    void attach(Entry& entry);
    void detach(Entry& entry) const;
    bool drop_lost();
    void update_roles(const scene::World& world);
    bool make_ray(Query& query, RTCRay& ray) const;
};

void TraceScene::State::start() {
    if (device) return;
    device.reset(rtcNewDevice(nullptr));
    CHECK(device != nullptr);
    tree.reset(rtcNewScene(device.get()));
    rtcSetSceneFlags(tree.get(), RTC_SCENE_FLAG_ROBUST);
}

/// Moves the origin into the middle of the world when pads made for the old one no longer suffice.
void TraceScene::State::anchor(const engine::WorldAabb& world_bounds) {
    if (world_bounds.empty()) return;
    const glm::dvec3 farthest =
        glm::max(glm::abs(world_bounds.min - origin), glm::abs(world_bounds.max - origin));
    const double needed = std::max({farthest.x, farthest.y, farthest.z});
    const glm::dvec3 half = 0.5 * world_bounds.extent();
    const double least = std::max({half.x, half.y, half.z, 1e-3});
    if (needed <= reach && reach <= 16.0 * least) return;
    for (auto& [entity, entry] : entries)
        detach(*entry);
    entries.clear();
    origin = glm::round(world_bounds.centre());
    reach = 2.0 * (least + 1.0);
}

void TraceScene::State::attach(Entry& entry) {
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(
        geometry, static_cast<unsigned int>(entry.exact.triangles.size()));
    rtcSetGeometryUserData(geometry, &entry);
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* a) { bounds_callback(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_callback);
    rtcSetGeometryOccludedFunction(geometry, occluded_callback);
    rtcCommitGeometry(geometry);
    entry.id = rtcAttachGeometry(tree.get(), geometry);
    rtcReleaseGeometry(geometry);
    ++builds;
}

void TraceScene::State::detach(Entry& entry) const {
    if (entry.id != RTC_INVALID_GEOMETRY_ID) rtcDetachGeometry(tree.get(), entry.id);
    entry.id = RTC_INVALID_GEOMETRY_ID;
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
    if (entry) detach(*entry);
    entry = std::make_unique<Entry>();
    entry->exact = exact_geometry(world, entity, origin);
    entry->versions = versions;
    entry->pad = kPad * reach;
    entry->found = true;
    if (!entry->exact.triangles.empty()) attach(*entry);
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
        detach(*at->second);
        at = entries.erase(at);
        dropped = true;
    }
    return dropped;
}

void TraceScene::State::update_roles(const scene::World& world) {
    for (auto& [entity, entry] : entries) {
        const auto* role = world.registry.try_get<scene::ShadowRole>(entity);
        entry->exact.casts = role == nullptr || role->casts;
        entry->exact.receives = role == nullptr || role->receives;
    }
}

/// The part of a query's ray that crosses the scene, in Embree's floats.
bool TraceScene::State::make_ray(Query& query, RTCRay& ray) const {
    if (bounds.empty()) return false;
    const double pad = kPad * reach;
    double t_min = query.t_min;
    double t_max = query.t_max;
    if (!clip({bounds.min - pad, bounds.max + pad}, query.origin, query.direction, t_min, t_max))
        return false;
    query.t_entry = t_min;
    const glm::vec3 start(query.origin + t_min * query.direction);
    ray.org_x = start.x;
    ray.org_y = start.y;
    ray.org_z = start.z;
    ray.dir_x = static_cast<float>(query.direction.x);
    ray.dir_y = static_cast<float>(query.direction.y);
    ray.dir_z = static_cast<float>(query.direction.z);
    ray.tnear = 0.0F;
    ray.tfar =
        static_cast<float>((t_max - t_min) * (1.0 + 1e-6) + pad / glm::length(query.direction));
    ray.mask = 0xFFFFFFFFU;
    return true;
}

TraceScene::TraceScene() : state_(std::make_unique<State>()) {}
TraceScene::~TraceScene() = default;
TraceScene::TraceScene(TraceScene&&) noexcept = default;
TraceScene& TraceScene::operator=(TraceScene&&) noexcept = default;

void TraceScene::update(const scene::World& world) {
    const ecs::Registry& registry = world.registry;
    State& state = *state_;
    const std::array<std::uint64_t, 4> versions = {
        registry.version<scene::MeshInstance>(),
        registry.version<scene::WorldTransform>(),
        registry.version<scene::PosedMesh>(),
        registry.version<scene::ShadowRole>()};
    if (versions == state.seen) return;
    state.seen = versions;
    state.start();
    state.anchor(scene::world_bounds(world));

    bool changed = false;
    registry.each<scene::MeshInstance, scene::WorldTransform>(
        [&](ecs::Entity entity, const auto& /*instance*/, const auto& /*transform*/) {
            changed = state.refresh(world, entity) || changed;
        });
    changed = state.drop_lost() || changed;
    state.update_roles(world);
    if (!changed) return;
    rtcCommitScene(state.tree.get());
    state.bounds = {};
    for (const auto& [entity, entry] : state.entries)
        state.bounds.grow(entry->exact.bounds);
}

std::optional<Hit>
TraceScene::intersect(const glm::dvec3& origin, const glm::dvec3& direction, double t_max) const {
    Query query;
    rtcInitIntersectContext(&query.context);
    query.origin = origin - state_->origin;
    query.direction = direction;
    query.t_max = t_max;
    query.primary = true;
    RTCRayHit ray = {};
    if (!state_->make_ray(query, ray.ray)) return std::nullopt;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->tree.get(), &query.context, &ray);
    if (query.nearest == nullptr) return std::nullopt;

    const ExactGeometry& exact = query.nearest->exact;
    const Crossing& crossing = query.crossing;
    Hit hit;
    hit.position = origin + crossing.t * direction;
    hit.normal = exact.normal(query.nearest_triangle);
    if (glm::dot(hit.normal, direction) > 0.0) hit.normal = -hit.normal;
    hit.entity = exact.entity;
    hit.triangle = exact.triangles[query.nearest_triangle].first_index;
    hit.patch_id = exact.triangles[query.nearest_triangle].patch_id;
    hit.receives = exact.receives;
    hit.t = crossing.t;
    hit.barycentrics = {1.0 - crossing.u - crossing.v, crossing.u, crossing.v};
    return hit;
}

bool TraceScene::occluded(
    const Surface& from, const glm::dvec3& to_light, double t_max, double offset) const {
    Query query;
    rtcInitIntersectContext(&query.context);
    query.origin = from.position - state_->origin + offset * from.normal;
    query.direction = to_light;
    query.t_max = t_max;
    query.casters_only = true;
    query.skip_entity = from.entity;
    query.skip_triangle = from.triangle;
    RTCRay ray = {};
    if (!state_->make_ray(query, ray)) return false;
    rtcOccluded1(state_->tree.get(), &query.context, &ray);
    return ray.tfar < 0.0F;
}

bool TraceScene::occluded(
    const glm::dvec3& origin, const glm::dvec3& direction, double distance) const {
    Query query;
    rtcInitIntersectContext(&query.context);
    query.origin = origin - state_->origin;
    query.direction = direction;
    query.t_max = distance / glm::length(direction);
    RTCRay ray = {};
    if (!state_->make_ray(query, ray)) return false;
    rtcOccluded1(state_->tree.get(), &query.context, &ray);
    return ray.tfar < 0.0F;
}

double TraceScene::default_offset() const {
    return state_->bounds.empty() ? 0.0 : 1e-6 * glm::length(state_->bounds.extent());
}

engine::WorldAabb TraceScene::bounds() const {
    if (state_->bounds.empty()) return {};
    return {state_->bounds.min + state_->origin, state_->bounds.max + state_->origin};
}

std::size_t TraceScene::triangle_count() const {
    std::size_t count = 0;
    for (const auto& [entity, entry] : state_->entries)
        count += entry->exact.triangles.size();
    return count;
}

std::uint64_t TraceScene::build_count() const {
    return state_->builds;
}

} // namespace trace
