#include "engine/play/plan_shape.hpp"

#include <algorithm>
#include <cmath>

namespace play {

namespace {

struct Polygon {
    std::array<glm::dvec3, 5> corners = {};
    int count = 0;

    void add(const glm::dvec3& corner) { corners[static_cast<std::size_t>(count++)] = corner; }
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Keeps what has sign * y > sign * height, with the cut.
Polygon clipped(const Polygon& polygon, double height, double sign) {
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3& from = polygon.corners[static_cast<std::size_t>(i)];
        const glm::dvec3& to = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
        const double from_above = sign * (from.y - height);
        const double to_above = sign * (to.y - height);
        if (from_above > 0.0) kept.add(from);
        if ((from_above > 0.0) != (to_above > 0.0))
            kept.add(from + from_above / (from_above - to_above) * (to - from));
    }
    return kept;
}

glm::dvec2 nearest_on(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& point) {
    const glm::dvec2 edge = to - from;
    const double square = glm::dot(edge, edge);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(point - from, edge) / square, 0.0, 1.0) : 0.0;
    return from + share * edge;
}

} // namespace

glm::dvec2 PlanShape::nearest(const glm::dvec2& point) const {
    glm::dvec2 best = corners[0];
    double best_square = glm::dot(point - best, point - best);
    bool left_of_all = count > 2;
    bool right_of_all = count > 2;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2& from = corners[static_cast<std::size_t>(i)];
        const glm::dvec2& to = corners[static_cast<std::size_t>((i + 1) % count)];
        const double side = cross(to - from, point - from);
        left_of_all = left_of_all && side > 0.0;
        right_of_all = right_of_all && side < 0.0;
        const glm::dvec2 candidate = nearest_on(from, to, point);
        const double square = glm::dot(point - candidate, point - candidate);
        if (square >= best_square) continue;
        best = candidate;
        best_square = square;
    }
    return left_of_all || right_of_all ? point : best;
}

std::optional<PlanShape> slice(const Triangle& triangle, double low, double high) {
    Polygon polygon;
    for (const glm::dvec3& corner : triangle)
        polygon.add(corner);
    polygon = clipped(clipped(polygon, low, 1.0), high, -1.0);
    if (polygon.count == 0) return std::nullopt;
    PlanShape shape;
    shape.count = polygon.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
        shape.corners[i] = {polygon.corners[i].x, polygon.corners[i].z};
    return shape;
}

std::optional<double> height_at(const Triangle& triangle, const glm::dvec2& point) {
    constexpr double kOverlap = 1e-9;
    const auto plan = [](const glm::dvec3& corner) { return glm::dvec2(corner.x, corner.z); };
    const glm::dvec2 edge_1 = plan(triangle[1] - triangle[0]);
    const glm::dvec2 edge_2 = plan(triangle[2] - triangle[0]);
    const double area = cross(edge_1, edge_2);
    const double longest = std::max(glm::dot(edge_1, edge_1), glm::dot(edge_2, edge_2));
    if (std::abs(area) <= kOverlap * longest) return std::nullopt;
    const glm::dvec2 offset = point - plan(triangle[0]);
    const double u = cross(offset, edge_2) / area;
    const double v = cross(edge_1, offset) / area;
    if (!(u >= -kOverlap && v >= -kOverlap && u + v <= 1.0 + kOverlap)) return std::nullopt;
    return triangle[0].y + u * (triangle[1].y - triangle[0].y)
           + v * (triangle[2].y - triangle[0].y);
}

} // namespace play
