// Masks whose figures are known in closed form: a half plane, an ellipse, a ramp, and the same seen
// through the texels of a shadow map. Pictures are functions of the place in px, read at pixel
// centres.

#pragma once

#include "engine/core/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/measure/mask.hpp"

namespace pictures {

struct Place {
    double x = 0.0;
    double y = 0.0;
};

/// The mask of a function of the place, top left origin.
template <class Visibility>
measure::Mask draw(int width, int height, Visibility visibility) {
    measure::Mask mask(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            mask.at(x, y) = static_cast<float>(visibility(Place{x + 0.5, y + 0.5}));
    return mask;
}

/// A straight edge: a ramp `width` px wide from dark to lit along the normal, hard when width is 0.
struct StraightEdge {
    Place normal; ///< unit length, points to the lit side
    double offset = 0.0;
    double width = 0.0;

    double operator()(Place p) const {
        const double distance = p.x * normal.x + p.y * normal.y - offset;
        if (width == 0.0) return distance >= 0.0 ? 1.0 : 0.0;
        return std::clamp(distance / width + 0.5, 0.0, 1.0);
    }
};

inline Place unit(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// Dark left of x, lit right of it.
inline StraightEdge upright_edge(double x, double width = 0.0) {
    return {{1.0, 0.0}, x, width};
}

/// Edge i of `count` through about the middle of a square picture: together they point in all
/// directions evenly.
inline StraightEdge turned_edge(int i, int count, int size, engine::Random& random) {
    const Place normal = unit(2.0 * std::numbers::pi * (i + random.uniform()) / count);
    const double middle = 0.5 * size * (normal.x + normal.y);
    return {normal, middle + random.uniform(-1.0, 1.0)};
}

/// Valid inside the largest disc, so that an edge through the middle is as long in any direction.
inline std::vector<measure::PixelKind> round_picture(int size) {
    std::vector<measure::PixelKind> kind;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            kind.push_back(
                std::hypot(x + 0.5 - 0.5 * size, y + 0.5 - 0.5 * size) < 0.5 * size
                    ? measure::PixelKind::valid
                    : measure::PixelKind::empty);
    return kind;
}

/// Dark inside.
struct Ellipse {
    Place centre;
    double a = 1.0;
    double b = 1.0;
    double angle = 0.0;

    double operator()(Place p) const {
        const double dx = p.x - centre.x;
        const double dy = p.y - centre.y;
        const double u = (dx * std::cos(angle) + dy * std::sin(angle)) / a;
        const double v = (dy * std::cos(angle) - dx * std::sin(angle)) / b;
        return u * u + v * v < 1.0 ? 0.0 : 1.0;
    }
};

/// A square texel grid over the picture.
struct Grid {
    double texel = 1.0;      ///< px
    Place axis = {1.0, 0.0}; ///< unit length, along the rows of texels
    Place origin;            ///< the corner of a texel

    /// In texels.
    [[nodiscard]] Place grid_from_picture(Place p) const {
        const double dx = (p.x - origin.x) / texel;
        const double dy = (p.y - origin.y) / texel;
        return {dx * axis.x + dy * axis.y, dy * axis.x - dx * axis.y};
    }
    [[nodiscard]] Place picture_from_grid(Place g) const {
        const double dx = g.x * texel;
        const double dy = g.y * texel;
        return {origin.x + dx * axis.x - dy * axis.y, origin.y + dx * axis.y + dy * axis.x};
    }
};

/// Far enough that every phase of a turned grid is equally likely.
inline Place random_origin(double texel, engine::Random& random) {
    return {random.uniform(0.0, 1000.0 * texel), random.uniform(0.0, 1000.0 * texel)};
}

inline Grid random_grid(double texel, engine::Random& random) {
    const Place axis = unit(random.uniform(0.0, 2.0 * std::numbers::pi));
    return {texel, axis, random_origin(texel, random)};
}

/// What a shadow map of these texels would say of the picture.
/// @param taps 0: the nearest texel; 1: bilinear over 2 x 2 texels; 3: the mean of 3 x 3 such
template <class Visibility>
auto through_map(const Visibility& visibility, const Grid& grid, int taps) {
    return [=](Place p) {
        const Place g = grid.grid_from_picture(p);
        const auto texel = [&](double x, double y) {
            return visibility(grid.picture_from_grid({x + 0.5, y + 0.5}));
        };
        if (taps == 0) return texel(std::floor(g.x), std::floor(g.y));
        const double x = std::floor(g.x - 0.5);
        const double y = std::floor(g.y - 0.5);
        const double right = g.x - 0.5 - x;
        const double down = g.y - 0.5 - y;
        const int reach = taps / 2;
        // A row of bilinear taps weighs its inner texels fully and its ends by the place inside the
        // texel.
        const auto weight = [&](int i, double part) {
            return i == -reach ? 1.0 - part : i == reach + 1 ? part : 1.0;
        };
        double sum = 0.0;
        for (int j = -reach; j <= reach + 1; ++j)
            for (int i = -reach; i <= reach + 1; ++i)
                sum += weight(i, right) * weight(j, down) * texel(x + i, y + j);
        return sum / (taps * taps);
    };
}

} // namespace pictures
