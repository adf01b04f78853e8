#include "systems/shadows/light_samples.hpp"

#include "engine/core/check.hpp"
#include "engine/core/random.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// Lamps nearer than that many of their radii count as that far away: their disc stays finite.
constexpr double kNearestInRadii = 1.1;
constexpr int kOutlineCorners = 8;
/// Of the third coordinate of Hammersley's points.
constexpr std::uint32_t kDepthBase = 3;

/// The digits of an index in reverse, as a fraction.
double radical_inverse(std::uint32_t index, std::uint32_t base = 2) {
    double value = 0.0;
    for (double digit = 1.0 / base; index != 0; index /= base, digit /= base)
        value += digit * (index % base);
    return value;
}

/// Points in rows of equal strata; `place` says where in its stratum a point lies.
template <class Place>
std::vector<glm::dvec2> stratified(int count, Place place) {
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(count))));
    std::vector<glm::dvec2> points;
    int first = 0;
    for (int row = 0; row < rows; ++row) {
        const int end = static_cast<int>(static_cast<std::int64_t>(count) * (row + 1) / rows);
        const int columns = end - first;
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 inside = place();
            points.emplace_back(
                (column + inside.x) / columns, (first + inside.y * columns) / count);
        }
        first = end;
    }
    return points;
}

bool is_sun(const LightView& light) {
    return light.light.kind == scene::LightKind::directional;
}

/// The cone of directions to a light from one place.
struct Cone {
    glm::dvec3 axis = {}; ///< unit, towards the light
    glm::dvec3 side = {};
    glm::dvec3 up = {};
    double distance = 0.0; ///< to its centre; of no use for suns
    double half_angle = 0.0;
};

Cone cone_of(const LightView& light, const glm::dvec3& seen_from) {
    Cone cone;
    if (is_sun(light)) {
        cone.axis = -glm::normalize(glm::dvec3(light.direction));
        cone.half_angle = static_cast<double>(light.light.angular_radius);
    } else {
        const auto radius = static_cast<double>(light.light.radius);
        const glm::dvec3 to_light = light.position - seen_from;
        const double length = glm::length(to_light);
        cone.axis = length > 0.0 ? to_light / length : glm::dvec3(0.0, 1.0, 0.0);
        cone.distance = std::max(length, kNearestInRadii * radius);
        cone.half_angle = cone.distance > 0.0 ? std::asin(radius / cone.distance) : 0.0;
    }
    const glm::dvec3 other =
        std::abs(cone.axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    cone.side = glm::normalize(glm::cross(other, cone.axis));
    cone.up = glm::cross(cone.axis, cone.side);
    return cone;
}

/// A light without a size, off the axis by `across` (a tangent of the angle, along side and up).
/// @param nearer to where it is seen from, metres; of lamps
LightView
point_of(const LightView& light, const Cone& cone, const glm::dvec2& across, double nearer = 0.0) {
    LightView point = light;
    point.light.radius = 0.0F;
    point.light.angular_radius = 0.0F;
    const glm::dvec3 offset = across.x * cone.side + across.y * cone.up;
    if (is_sun(light))
        point.direction = glm::vec3(-glm::normalize(cone.axis + offset));
    else
        point.position = light.position + cone.distance * offset - nearer * cone.axis;
    return point;
}

} // namespace

std::vector<glm::dvec2> square_samples(SamplePattern pattern, int count) {
    CHECK_GT(count, 0);
    if (pattern == SamplePattern::regular) return stratified(count, [] { return glm::dvec2(0.5); });
    if (pattern == SamplePattern::jittered) {
        engine::Random random(static_cast<std::uint64_t>(count));
        return stratified(count, [&] {
            const double x = random.uniform();
            return glm::dvec2(x, random.uniform());
        });
    }
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back((i + 0.5) / count, radical_inverse(static_cast<std::uint32_t>(i)));
    return points;
}

glm::dvec2 disc_from_square(const glm::dvec2& square) {
    const glm::dvec2 at = 2.0 * square - 1.0;
    if (at == glm::dvec2(0.0)) return at;
    const bool wide = std::abs(at.x) > std::abs(at.y);
    const double radius = wide ? at.x : at.y;
    const double turn = wide ? glm::quarter_pi<double>() * (at.y / at.x)
                             : glm::half_pi<double>() - glm::quarter_pi<double>() * (at.x / at.y);
    return radius * glm::dvec2(std::cos(turn), std::sin(turn));
}

bool has_size(const LightView& light) {
    return (is_sun(light) ? light.light.angular_radius : light.light.radius) > 0.0F;
}

std::vector<LightView> light_samples(
    const LightView& light, const glm::dvec3& seen_from, int count, SamplePattern pattern) {
    const Cone cone = cone_of(light, seen_from);
    if (!has_size(light) || count == 1) return {point_of(light, cone, {})};
    const auto radius = static_cast<double>(light.light.radius);
    std::vector<LightView> points;
    for (const glm::dvec2& square : square_samples(pattern, count)) {
        const glm::dvec2 disc = disc_from_square(square);
        const double part = std::min(glm::length(disc), 1.0);
        const double turn =
            glm::two_pi<double>()
            * radical_inverse(static_cast<std::uint32_t>(points.size()), kDepthBase);
        const double nearer = radius * std::sqrt(1.0 - part * part) * std::cos(turn);
        // Even over the solid angle: the square of the radius goes with 1 - cosine.
        const double sine = part * std::sin(0.5 * cone.half_angle);
        const double tangent = std::tan(2.0 * std::asin(sine));
        points.push_back(
            point_of(light, cone, part > 0.0 ? disc / part * tangent : glm::dvec2(0.0), nearer));
    }
    return points;
}

std::vector<LightView> light_outline(const LightView& light, const glm::dvec3& seen_from) {
    const Cone cone = cone_of(light, seen_from);
    if (!has_size(light)) return {point_of(light, cone, {})};
    if (!is_sun(light)) {
        std::vector<LightView> corners(kOutlineCorners, point_of(light, cone, {}));
        for (int i = 0; i < kOutlineCorners; ++i)
            corners[static_cast<std::size_t>(i)].position +=
                static_cast<double>(light.light.radius)
                * glm::dvec3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
        return corners;
    }
    // Corners of the polygon round the disc.
    const double tangent =
        std::tan(cone.half_angle) / std::cos(glm::pi<double>() / kOutlineCorners);
    std::vector<LightView> corners;
    for (int i = 0; i < kOutlineCorners; ++i) {
        const double turn = glm::two_pi<double>() * i / kOutlineCorners;
        corners.push_back(
            point_of(light, cone, tangent * glm::dvec2(std::cos(turn), std::sin(turn))));
    }
    return corners;
}

double sampling_error(int count) {
    return 0.35 * std::pow(count, -0.75);
}

int samples_for(double penumbra_px, double accepted_px) {
    if (penumbra_px <= 0.0) return 1;
    int count = kFewestSamples;
    while (count < kMostSamples && sampling_error(count) * penumbra_px > accepted_px)
        count *= 2;
    return count;
}

} // namespace shadows
