// The tree that proposes triangles to rays, by Embree, and the exact test that decides on each
// proposal.
//
// The tree knows triangles by their bounds only, padded so that its float arithmetic never misses
// one; so what a ray meets is decided by ExactGeometry alone.

#pragma once

#include "engine/trace/exact_geometry.hpp"

#include <embree3/rtcore.h>
#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

namespace trace {

/// One entity in the tree. Stays where it is while it is attached.
struct TracedEntity {
    ExactGeometry exact;
    double pad = 0.0; ///< metres, round every triangle
    unsigned int id = RTC_INVALID_GEOMETRY_ID;
};

/// A question and its answer; t counts in lengths of the direction. Plain data: the tree hands out
/// its address.
struct RayQuery {
    RTCIntersectContext context = {}; ///< first: Embree knows the query by it
    glm::dvec3 origin = {};           ///< relative to the scene's origin
    glm::dvec3 direction = {};
    double t_min = 0.0;
    double t_max = std::numeric_limits<double>::infinity();
    bool primary = false; ///< back faces of single-sided materials are not there
    bool casters_only = false;
    ecs::Entity skip_entity; ///< with skip_triangle: the triangle that is not there
    std::uint32_t skip_triangle = 0;

    double t_entry = 0.0; ///< where the tree's ray starts on the exact one
    const TracedEntity* nearest = nullptr;
    std::uint32_t nearest_triangle = 0;
    Crossing crossing = {};
};

class CandidateTree {
public:
    /// Aborts when Embree can not start.
    CandidateTree();

    void attach(TracedEntity& traced);
    void detach(TracedEntity& traced);
    /// Rebuilds the tree. @param bounds of everything attached, with its pads
    void commit(const engine::Box<glm::dvec3>& bounds);

    /// Fills nearest, nearest_triangle and crossing. Equal distances go to the lower entity and
    /// triangle, so that answers do not depend on the order of the tree.
    void find_nearest(RayQuery& query) const;
    [[nodiscard]] bool finds_any(RayQuery& query) const;

private:
    struct ReleaseDevice {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    };
    struct ReleaseScene {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };

    bool make_ray(RayQuery& query, RTCRay& ray) const;

    std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice> device_;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene> scene_;
    engine::Box<glm::dvec3> bounds_;
};

} // namespace trace
