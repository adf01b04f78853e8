#include "engine/scene/box_set.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <numbers>

namespace scene {

namespace {

constexpr int kSide = 64; ///< cells of a picture
constexpr std::size_t kTrianglesPerBox = 12;
constexpr int kHalvings = 3;

using Picture = std::bitset<static_cast<std::size_t>(kSide) * kSide>;
using Triangle = std::array<glm::vec3, 3>;

std::size_t cell(int x, int y) {
    return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
}

/// A view along an axis: where the mesh's bounds fill the picture.
struct View {
    int right = 0; ///< axes
    int up = 1;
    glm::vec2 from = {};
    glm::vec2 cells_per_unit = {};

    View(int axis, const engine::Aabb& bounds)
        : right((axis + 1) % 3),
          up((axis + 2) % 3),
          from(bounds.min[right], bounds.min[up]) {
        const glm::vec2 size = glm::vec2(bounds.max[right], bounds.max[up]) - from;
        cells_per_unit = static_cast<float>(kSide) / glm::max(size, glm::vec2(1e-12F));
    }
    [[nodiscard]] glm::vec2 place(const glm::vec3& point) const {
        return (glm::vec2(point[right], point[up]) - from) * cells_per_unit;
    }
};

/// The cells whose centre lies between two places.
glm::ivec4 cells_between(const glm::vec2& low, const glm::vec2& high) {
    const glm::ivec2 first(glm::ceil(low - 0.5F));
    const glm::ivec2 last(glm::floor(high - 0.5F));
    return {glm::max(first, glm::ivec2(0)), glm::min(last, glm::ivec2(kSide - 1))};
}

float cross(const glm::vec2& a, const glm::vec2& b) {
    return a.x * b.y - a.y * b.x;
}

void paint(Picture& picture, const View& view, const Triangle& triangle) {
    const glm::vec2 a = view.place(triangle[0]);
    const glm::vec2 b = view.place(triangle[1]);
    const glm::vec2 c = view.place(triangle[2]);
    const glm::ivec4 cells =
        cells_between(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)));
    for (int y = cells.y; y <= cells.w; ++y)
        for (int x = cells.x; x <= cells.z; ++x) {
            const glm::vec2 at = glm::vec2(x, y) + 0.5F;
            const float ab = cross(b - a, at - a);
            const float bc = cross(c - b, at - b);
            const float ca = cross(a - c, at - c);
            const bool inside = (ab >= 0.0F && bc >= 0.0F && ca >= 0.0F)
                                || (ab <= 0.0F && bc <= 0.0F && ca <= 0.0F);
            if (inside) picture.set(cell(x, y));
        }
}

void paint(Picture& picture, const View& view, const engine::Aabb& box) {
    const glm::ivec4 cells = cells_between(view.place(box.min), view.place(box.max));
    for (int y = cells.y; y <= cells.w; ++y)
        for (int x = cells.x; x <= cells.z; ++x)
            picture.set(cell(x, y));
}

/// Length of the outline in mesh units. Source: Crofton's formula over the sides of the cells.
double outline(const Picture& picture, const View& view) {
    const auto full = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < kSide && y < kSide && picture.test(cell(x, y));
    };
    double across = 0.0;
    double along = 0.0;
    for (int y = -1; y < kSide; ++y)
        for (int x = -1; x < kSide; ++x) {
            if (full(x, y) != full(x + 1, y)) across += 1.0;
            if (full(x, y) != full(x, y + 1)) along += 1.0;
        }
    const glm::dvec2 cells(view.cells_per_unit);
    return (across / cells.y + along / cells.x) * std::numbers::pi / 4.0;
}

/// The farthest that a cell of `outer` is from the cells of `inner`, in mesh units; 0 where either
/// has none. Source: T. Saito and J. Toriwaki, "New Algorithms for Euclidean Distance
/// Transformation of an n-Dimensional Digitized Picture", 1994.
double farthest(const Picture& outer, const Picture& inner, const View& view) {
    if (inner.none()) return 0.0;
    constexpr double kFar = 1e9; // cells
    std::array<double, Picture().size()> along_row = {};
    for (int y = 0; y < kSide; ++y) {
        double left = kFar;
        double right = kFar;
        for (int x = 0; x < kSide; ++x) {
            left = inner.test(cell(x, y)) ? 0.0 : left + 1.0;
            along_row[cell(x, y)] = left;
        }
        for (int x = kSide - 1; x >= 0; --x) {
            right = inner.test(cell(x, y)) ? 0.0 : right + 1.0;
            along_row[cell(x, y)] = std::min(along_row[cell(x, y)], right);
        }
    }
    const glm::dvec2 cell_size = 1.0 / glm::dvec2(view.cells_per_unit);
    double most = 0.0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (!outer.test(cell(x, y)) || inner.test(cell(x, y))) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (int row = 0; row < kSide; ++row)
                nearest = std::min(
                    nearest, glm::length(glm::dvec2(along_row[cell(x, row)], row - y) * cell_size));
            most = std::max(most, nearest);
        }
    return most;
}

/// Of the farthest place, what counts as deviation.
constexpr double kFarthestShare = 0.25;

float deviation(
    const std::vector<engine::Aabb>& boxes,
    const std::vector<Triangle>& triangles,
    const engine::Aabb& bounds) {
    double worst = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const View view(axis, bounds);
        Picture of_mesh;
        Picture of_boxes;
        for (const Triangle& triangle : triangles)
            paint(of_mesh, view, triangle);
        for (const engine::Aabb& box : boxes)
            paint(of_boxes, view, box);
        const glm::dvec2 cells(view.cells_per_unit);
        const double between =
            static_cast<double>((of_mesh ^ of_boxes).count()) / (cells.x * cells.y);
        const double length = outline(of_boxes, view);
        if (length > 0.0) worst = std::max(worst, between / length);
        worst = std::max(worst, kFarthestShare * farthest(of_boxes, of_mesh, view));
    }
    return static_cast<float>(worst);
}

engine::Aabb bounds_of(std::span<const Triangle> triangles) {
    engine::Aabb box;
    for (const Triangle& triangle : triangles)
        for (const glm::vec3& corner : triangle)
            box.grow(corner);
    return box;
}

/// Reorders the triangles.
void halve(std::span<Triangle> triangles, int times, std::vector<engine::Aabb>& boxes) {
    const engine::Aabb bounds = bounds_of(triangles);
    if (times == 0 || triangles.size() < 2) {
        boxes.push_back(bounds);
        return;
    }
    const glm::vec3 size = bounds.extent();
    const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
    std::nth_element(
        triangles.begin(), middle, triangles.end(), [&](const Triangle& a, const Triangle& b) {
            return a[0][longest] + a[1][longest] + a[2][longest]
                   < b[0][longest] + b[1][longest] + b[2][longest];
        });
    halve({triangles.begin(), middle}, times - 1, boxes);
    halve({middle, triangles.end()}, times - 1, boxes);
}

} // namespace

std::vector<BoxSet>
make_box_sets(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles) {
    std::vector<Triangle> all;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        all.push_back(
            {positions[triangles[i]], positions[triangles[i + 1]], positions[triangles[i + 2]]});
    std::vector<BoxSet> sets;
    const engine::Aabb bounds = bounds_of(all);
    for (const int times : {0, kHalvings}) {
        BoxSet set;
        std::vector<Triangle> parts = all;
        if (all.size() <= (kTrianglesPerBox << static_cast<unsigned>(times))) break;
        halve(parts, times, set.boxes);
        set.deviation = deviation(set.boxes, all, bounds);
        sets.push_back(std::move(set));
    }
    return sets;
}

} // namespace scene
