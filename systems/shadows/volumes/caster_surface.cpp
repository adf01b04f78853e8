#include "systems/shadows/volumes/caster_surface.hpp"

#include "engine/scene/welded_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace shadows {

namespace {

using scene::TriangleSide;

/// Whether whatever moves one vertex moves the other alike.
bool moves_alike(const scene::Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    if (!mesh.influences.empty()
        && (mesh.influences[a].joints != mesh.influences[b].joints
            || mesh.influences[a].weights != mesh.influences[b].weights))
        return false;
    return std::all_of(
        mesh.morph_targets.begin(),
        mesh.morph_targets.end(),
        [&](const scene::MorphTarget& target) {
            return target.position_deltas[a] == target.position_deltas[b];
        });
}

/// The first vertex of those at the same place that move alike, for every vertex.
std::vector<std::uint32_t> weld(const scene::Mesh& mesh) {
    std::vector<std::uint32_t> welded = scene::weld_by_position(mesh.positions);
    if (!mesh.deforms()) return welded;
    std::multimap<std::uint32_t, std::uint32_t> firsts; // by place
    for (std::uint32_t vertex = 0; vertex < welded.size(); ++vertex) {
        const auto [begin, end] = firsts.equal_range(welded[vertex]);
        const auto same = std::find_if(
            begin, end, [&](const auto& first) { return moves_alike(mesh, first.second, vertex); });
        if (same == end) firsts.emplace(welded[vertex], vertex);
        welded[vertex] = same == end ? vertex : same->second;
    }
    return welded;
}

/// A surface while it is made.
class Builder {
public:
    Builder(const scene::Mesh& mesh, const Remedies& remedies)
        : mesh_(mesh),
          remedies_(remedies),
          welded_(weld(mesh)) {}

    CasterSurface build() {
        take_triangles();
        sides_ = scene::sides_by_edge(welded_corners_);
        surface_.turned.assign(welded_corners_.size() / 3, 0);
        part_.resize(surface_.turned.size());
        if (remedies_.on(Remedy::volume_signed_edges)) {
            find_neighbours();
            orient_parts();
        }
        judge_parts();
        pair_sides();
        return std::move(surface_);
    }

private:
    void take_triangles() {
        for (const scene::Submesh& submesh : mesh_.submeshes) {
            if (submesh.topology != scene::Topology::triangles) continue;
            for (std::uint32_t i = 0; i < submesh.index_count; i += 3) {
                std::array<std::uint32_t, 3> drawn{};
                std::array<std::uint32_t, 3> joined{};
                for (std::uint32_t k = 0; k < 3; ++k) {
                    drawn[k] = mesh_.indices[submesh.first_index + i + k];
                    joined[k] = welded_[drawn[k]];
                }
                if (joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0])
                    continue;
                surface_.corners.insert(surface_.corners.end(), drawn.begin(), drawn.end());
                welded_corners_.insert(welded_corners_.end(), joined.begin(), joined.end());
            }
        }
    }

    /// Across each side, the triangle there where exactly two meet.
    void find_neighbours() {
        neighbours_.resize(surface_.turned.size());
        scene::for_each_edge(sides_, [&](std::span<const TriangleSide> sides) {
            if (sides.size() != 2) return;
            const bool against = sides[0].rising == sides[1].rising;
            neighbours_[sides[0].triangle].push_back({sides[1].triangle, against});
            neighbours_[sides[1].triangle].push_back({sides[0].triangle, against});
        });
    }

    /// Walks from triangle to triangle, turning each as its neighbour has it.
    void orient_parts() {
        constexpr std::uint32_t kUnknown = 0xFFFFFFFFU;
        std::fill(part_.begin(), part_.end(), kUnknown);
        std::vector<std::uint32_t> queue;
        for (std::uint32_t start = 0; start < part_.size(); ++start) {
            if (part_[start] != kUnknown) continue;
            part_[start] = part_count_;
            queue.assign(1, start);
            while (!queue.empty()) {
                const std::uint32_t triangle = queue.back();
                queue.pop_back();
                for (const Neighbour& next : neighbours_[triangle]) {
                    if (part_[next.triangle] != kUnknown) continue;
                    part_[next.triangle] = part_count_;
                    surface_.turned[next.triangle] = static_cast<std::uint8_t>(
                        surface_.turned[triangle] ^ (next.against ? 1U : 0U));
                    queue.push_back(next.triangle);
                }
            }
            ++part_count_;
        }
    }

    /// +1 for a side that runs up as its triangle is turned now, -1 for one that runs down.
    [[nodiscard]] int direction(const TriangleSide& side) const {
        return side.rising != (surface_.turned[side.triangle] != 0) ? 1 : -1;
    }

    /// Which parts are closed, and turns those inside out that enclose a negative volume.
    void judge_parts() {
        surface_.dark_weight.assign(surface_.turned.size(), 0);
        if (!remedies_.on(Remedy::volume_signed_edges)) return;
        std::vector<bool> closed(part_count_, true);
        scene::for_each_edge(sides_, [&](std::span<const TriangleSide> sides) {
            for (const TriangleSide& side : sides) {
                int sum = 0;
                for (const TriangleSide& other : sides)
                    if (part_[other.triangle] == part_[side.triangle]) sum += direction(other);
                if (sum != 0) closed[part_[side.triangle]] = false;
            }
        });
        const std::vector<double> volumes = enclosed_volumes();
        for (std::size_t t = 0; t < part_.size(); ++t) {
            if (!closed[part_[t]]) surface_.dark_weight[t] = -1;
            if (closed[part_[t]] && volumes[part_[t]] < 0.0) surface_.turned[t] ^= 1U;
        }
    }

    /// Of each part, times six. Source: the divergence theorem over its triangles.
    [[nodiscard]] std::vector<double> enclosed_volumes() const {
        const glm::dvec3 centre(mesh_.bounds.centre());
        std::vector<double> volumes(part_count_, 0.0);
        for (std::size_t t = 0; t < part_.size(); ++t) {
            const auto corner = [&](std::size_t k) {
                return glm::dvec3(mesh_.positions[welded_corners_[3 * t + k]]) - centre;
            };
            const double six = glm::dot(corner(0), glm::cross(corner(1), corner(2)));
            volumes[part_[t]] += surface_.turned[t] != 0 ? -six : six;
        }
        return volumes;
    }

    /// Sides that run against each other become one edge, those of one part before all others.
    void pair_sides() {
        std::vector<TriangleSide> rest;
        scene::for_each_edge(sides_, [&](std::span<const TriangleSide> sides) {
            rest.assign(sides.begin(), sides.end());
            for (const bool within_part : {true, false})
                while (take_pair(rest, within_part)) {
                }
            for (const TriangleSide& side : rest)
                add_edge(side, nullptr);
        });
    }

    /// Makes an edge of the first two sides that fit. @return false when none do
    bool take_pair(std::vector<TriangleSide>& sides, bool within_part) {
        for (std::size_t i = 0; i < sides.size(); ++i)
            for (std::size_t k = i + 1; k < sides.size(); ++k) {
                const TriangleSide a = sides[i];
                const TriangleSide b = sides[k];
                if (direction(a) == direction(b)) continue;
                if (within_part && part_[a.triangle] != part_[b.triangle]) continue;
                add_edge(a, &b);
                sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(k));
                sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(i));
                return true;
            }
        return false;
    }

    void add_edge(const TriangleSide& side, const TriangleSide* opposite) {
        const std::uint32_t other =
            opposite != nullptr ? opposite->triangle : surface_.triangle_count();
        const bool up = direction(side) > 0;
        surface_.edges.push_back(
            {static_cast<std::uint32_t>(side.edge >> 32U),
             static_cast<std::uint32_t>(side.edge),
             up ? side.triangle : other,
             up ? other : side.triangle});
    }

    struct Neighbour {
        std::uint32_t triangle = 0;
        bool against = false; ///< it runs their edge the same way, so one of them has to turn
    };

    const scene::Mesh& mesh_;
    const Remedies& remedies_;
    std::vector<std::uint32_t> welded_;
    std::vector<std::uint32_t> welded_corners_;
    std::vector<TriangleSide> sides_;
    std::vector<std::vector<Neighbour>> neighbours_;
    std::vector<std::uint32_t> part_; ///< of each triangle
    std::uint32_t part_count_ = 1;
    CasterSurface surface_;
};

/// Rays per side of the grid that layers are counted on.
constexpr int kGrid = 48;

/// The most triangles over one point of a grid, seen along an axis.
int layers_along(const CasterSurface& surface, std::span<const glm::vec3> positions, int axis) {
    const int x = (axis + 1) % 3;
    const int y = (axis + 2) % 3;
    engine::Aabb bounds;
    for (const std::uint32_t corner : surface.corners)
        bounds.grow(positions[corner]);
    const glm::dvec3 extent = glm::max(glm::dvec3(bounds.extent()), glm::dvec3(1e-30));
    const auto cell = [&](std::uint32_t corner) {
        const glm::dvec3 at = (glm::dvec3(positions[corner]) - glm::dvec3(bounds.min)) / extent;
        return glm::dvec2(at[x], at[y]) * static_cast<double>(kGrid) - 0.4871; // on no symmetry
    };
    std::vector<int> layers(std::size_t{kGrid} * kGrid, 0);
    const auto across = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x * b.y - a.y * b.x;
    };
    for (std::size_t i = 0; i < surface.corners.size(); i += 3) {
        const glm::dvec2 a = cell(surface.corners[i]);
        const glm::dvec2 b = cell(surface.corners[i + 1]);
        const glm::dvec2 c = cell(surface.corners[i + 2]);
        const glm::dvec2 low = glm::max(glm::ceil(glm::min(a, glm::min(b, c))), glm::dvec2(0.0));
        const glm::dvec2 high =
            glm::min(glm::floor(glm::max(a, glm::max(b, c))), glm::dvec2(kGrid - 1));
        for (int row = static_cast<int>(low.y); row <= static_cast<int>(high.y); ++row)
            for (int column = static_cast<int>(low.x); column <= static_cast<int>(high.x);
                 ++column) {
                const glm::dvec2 p(column, row);
                const bool left = across(b - a, p - a) >= 0.0;
                if (left == (across(c - b, p - b) >= 0.0) && left == (across(a - c, p - c) >= 0.0))
                    ++layers[static_cast<std::size_t>(row * kGrid + column)];
            }
    }
    return *std::max_element(layers.begin(), layers.end());
}

} // namespace

CasterSurface make_caster_surface(const scene::Mesh& mesh, const Remedies& remedies) {
    return Builder(mesh, remedies).build();
}

int count_layers(const CasterSurface& surface, std::span<const glm::vec3> positions) {
    if (surface.corners.empty()) return 0;
    int most = 0;
    for (int axis = 0; axis < 3; ++axis)
        most = std::max(most, layers_along(surface, positions, axis));
    return std::min(2 * most, static_cast<int>(surface.triangle_count()));
}

} // namespace shadows
