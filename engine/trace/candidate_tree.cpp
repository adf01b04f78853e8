#include "engine/trace/candidate_tree.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trace {
namespace {

/// Rays of the tree end this much later than exact ones, so that it still proposes what lies at the
/// same distance.
constexpr double kLater = 1.0 + 1e-6;

/// The crossing of a query with a triangle, when there is one that counts.
std::optional<Crossing>
crossing_of(const RayQuery& query, const TracedEntity& traced, std::uint32_t triangle) {
    const ExactGeometry& exact = traced.exact;
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

bool nearer(
    const RayQuery& query,
    const Crossing& crossing,
    const TracedEntity& traced,
    std::uint32_t triangle) {
    if (query.nearest == nullptr || crossing.t != query.crossing.t)
        return query.nearest == nullptr || crossing.t < query.crossing.t;
    if (traced.exact.entity != query.nearest->exact.entity)
        return traced.exact.entity < query.nearest->exact.entity;
    return triangle < query.nearest_triangle;
}

void bounds_callback(const RTCBoundsFunctionArguments* arguments) {
    const auto& traced = *static_cast<const TracedEntity*>(arguments->geometryUserPtr);
    const auto box = traced.exact.triangle_bounds(arguments->primID);
    const glm::vec3 lower(box.min - traced.pad);
    const glm::vec3 upper(box.max + traced.pad);
    *arguments->bounds_o = {lower.x, lower.y, lower.z, 0.0F, upper.x, upper.y, upper.z, 0.0F};
}

void intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    const auto& traced = *static_cast<const TracedEntity*>(arguments->geometryUserPtr);
    auto& query = *reinterpret_cast<RayQuery*>(arguments->context);
    const auto crossing = crossing_of(query, traced, arguments->primID);
    if (!crossing || !nearer(query, *crossing, traced, arguments->primID)) return;
    query.nearest = &traced;
    query.nearest_triangle = arguments->primID;
    query.crossing = *crossing;
    const double later =
        (crossing->t - query.t_entry) * kLater + traced.pad / glm::length(query.direction);
    RTCRayN* ray = RTCRayHitN_RayN(arguments->rayhit, 1);
    RTCRayN_tfar(ray, 1, 0) = std::min(RTCRayN_tfar(ray, 1, 0), static_cast<float>(later));
}

void occluded_callback(const RTCOccludedFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    const auto& traced = *static_cast<const TracedEntity*>(arguments->geometryUserPtr);
    const auto& query = *reinterpret_cast<const RayQuery*>(arguments->context);
    if (crossing_of(query, traced, arguments->primID))
        RTCRayN_tfar(arguments->ray, 1, 0) = -std::numeric_limits<float>::infinity();
}

/// Cuts [t_min, t_max] down to what lies in the box; false when nothing does.
/// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986.
bool clip(const engine::Box<glm::dvec3>& box, const RayQuery& query, double& t_min, double& t_max) {
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = query.origin[axis];
        const double direction = query.direction[axis];
        if (direction == 0.0) {
            if (origin < box.min[axis] || origin > box.max[axis]) return false;
            continue;
        }
        const double a = (box.min[axis] - origin) / direction;
        const double b = (box.max[axis] - origin) / direction;
        t_min = std::max(t_min, std::min(a, b));
        t_max = std::min(t_max, std::max(a, b));
    }
    return t_min <= t_max;
}

} // namespace

CandidateTree::CandidateTree() : device_(rtcNewDevice(nullptr)) {
    CHECK(device_ != nullptr);
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
}

void CandidateTree::attach(TracedEntity& traced) {
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(
        geometry, static_cast<unsigned int>(traced.exact.triangles.size()));
    rtcSetGeometryUserData(geometry, &traced);
    rtcSetGeometryBoundsFunction(geometry, bounds_callback, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_callback);
    rtcSetGeometryOccludedFunction(geometry, occluded_callback);
    rtcCommitGeometry(geometry);
    traced.id = rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
}

void CandidateTree::detach(TracedEntity& traced) {
    if (traced.id != RTC_INVALID_GEOMETRY_ID) rtcDetachGeometry(scene_.get(), traced.id);
    traced.id = RTC_INVALID_GEOMETRY_ID;
}

void CandidateTree::commit(const engine::Box<glm::dvec3>& bounds) {
    rtcCommitScene(scene_.get());
    bounds_ = bounds;
}

/// The part of a query's ray that crosses the scene, in floats.
bool CandidateTree::make_ray(RayQuery& query, RTCRay& ray) const {
    if (bounds_.empty()) return false;
    double t_min = query.t_min;
    double t_max = query.t_max;
    if (!clip(bounds_, query, t_min, t_max)) return false;
    rtcInitIntersectContext(&query.context);
    query.t_entry = t_min;
    const glm::vec3 start(query.origin + t_min * query.direction);
    const glm::vec3 direction(query.direction);
    ray.org_x = start.x;
    ray.org_y = start.y;
    ray.org_z = start.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tnear = 0.0F;
    ray.tfar = static_cast<float>((t_max - t_min) * kLater) + std::numeric_limits<float>::min();
    ray.mask = 0xFFFFFFFFU;
    return true;
}

void CandidateTree::find_nearest(RayQuery& query) const {
    RTCRayHit ray = {};
    if (!make_ray(query, ray.ray)) return;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &query.context, &ray);
}

bool CandidateTree::finds_any(RayQuery& query) const {
    RTCRay ray = {};
    if (!make_ray(query, ray)) return false;
    rtcOccluded1(scene_.get(), &query.context, &ray);
    return ray.tfar < 0.0F;
}

} // namespace trace
