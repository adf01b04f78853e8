// What stands in a walker's way: triangles of the world, found by the box that they touch.

#pragma once

#include "engine/core/geometry.hpp"
#include "engine/scene/world.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace play {

/// World space; both sides are solid.
using Triangle = std::array<glm::dvec3, 3>;

/// The triangles of everything that keeps its place: what deforms, or goes along a path, is left
/// out. @pre update_world_transforms() ran since the last change
std::vector<Triangle> standing_triangles(const scene::World& world);

/// Triangles in a tree of boxes. Built once; never changes.
class Obstacles {
public:
    /// Cost: n log n.
    explicit Obstacles(std::vector<Triangle> triangles);

    /// Calls `function` with each triangle whose box touches `box`, in an order that depends on the
    /// triangles alone.
    template <class Function>
    void each_near(const engine::WorldAabb& box, Function&& function) const {
        std::vector<std::uint32_t> open;
        if (!nodes_.empty()) open.push_back(0);
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (!node.bounds.intersects(box)) continue;
            if (node.count == 0) {
                open.push_back(node.second_child);
                open.push_back(node.first);
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i)
                if (bounds_of(triangles_[node.first + i]).intersects(box))
                    function(triangles_[node.first + i]);
        }
    }

    [[nodiscard]] engine::WorldAabb bounds() const {
        return nodes_.empty() ? engine::WorldAabb() : nodes_.front().bounds;
    }

    static engine::WorldAabb bounds_of(const Triangle& triangle);

private:
    struct Node {
        engine::WorldAabb bounds;
        std::uint32_t first = 0; ///< triangle of a leaf, first child of others
        std::uint32_t second_child = 0;
        std::uint32_t count = 0; ///< triangles of a leaf; 0: has children
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

} // namespace play
