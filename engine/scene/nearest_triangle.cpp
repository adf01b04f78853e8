#include "engine/scene/nearest_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace scene {

namespace {

/// Fewer triangles are tried one by one.
constexpr std::uint32_t kLeaf = 4;

double squared(const glm::dvec3& v) {
    return glm::dot(v, v);
}

double squared_distance(const glm::dvec3& p, const engine::Aabb& box) {
    return squared(p - glm::clamp(p, glm::dvec3(box.min), glm::dvec3(box.max)));
}

} // namespace

glm::dvec3 nearest_on_triangle(
    const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double d1 = glm::dot(ab, p - a);
    const double d2 = glm::dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = glm::dot(ab, p - b);
    const double d4 = glm::dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double d5 = glm::dot(ab, p - c);
    const double d6 = glm::dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / (d1 - d3));
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6)
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    return a + (ab * vb + ac * vc) / (va + vb + vc);
}

NearestTriangle::NearestTriangle(
    std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners)
    : positions_(positions),
      corners_(corners),
      order_(corners.size() / 3) {
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.reserve(order_.size());
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::size_t node = 0; node < nodes_.size(); ++node)
        split(node);
}

glm::dvec3 NearestTriangle::corner(std::uint32_t triangle, std::size_t k) const {
    return positions_[corners_[std::size_t{3} * triangle + k]];
}

glm::dvec3 NearestTriangle::middle(std::uint32_t triangle) const {
    return (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3.0;
}

/// Bounds a node and halves it at the median of its longest side.
void NearestTriangle::split(std::size_t node) {
    const auto begin = order_.begin() + nodes_[node].first;
    const std::uint32_t count = nodes_[node].count;
    engine::Aabb middles;
    for (auto triangle = begin; triangle != begin + count; ++triangle) {
        middles.grow(glm::vec3(middle(*triangle)));
        for (std::size_t k = 0; k < 3; ++k)
            nodes_[node].box.grow(positions_[corners_[std::size_t{3} * *triangle + k]]);
    }
    if (count <= kLeaf) return;
    const glm::vec3 extent = middles.extent();
    int axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double at_a = middle(a)[axis];
        const double at_b = middle(b)[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    const std::uint32_t first = nodes_[node].first;
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, first, half});
    nodes_.push_back({{}, first + half, count - half});
}

double NearestTriangle::distance(const glm::dvec3& point) const {
    double best = std::numeric_limits<double>::infinity();
    std::array<std::uint32_t, 64> open{}; // halving keeps the tree shallower than that
    std::size_t open_count = 1;
    while (open_count > 0) {
        const Node& node = nodes_[open[--open_count]];
        if (squared_distance(point, node.box) >= best) continue;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const std::uint32_t t = order_[node.first + i];
            best = std::min(
                best,
                squared(
                    point - nearest_on_triangle(point, corner(t, 0), corner(t, 1), corner(t, 2))));
        }
        if (node.count > 0) continue;
        // The nearer child is looked at first.
        const bool second_nearer = squared_distance(point, nodes_[node.first + 1].box)
                                   < squared_distance(point, nodes_[node.first].box);
        open[open_count++] = node.first + (second_nearer ? 0 : 1);
        open[open_count++] = node.first + (second_nearer ? 1 : 0);
    }
    return std::sqrt(best);
}

} // namespace scene
