#include "tools/measure/flip.hpp"

#include "engine/core/check.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/measure/filter.hpp"

namespace measure {

namespace {

// Names and values of the paper.
constexpr double kColorExponent = 0.7;     // q_c
constexpr double kFeatureExponent = 0.5;   // q_f
constexpr double kSmallErrors = 0.4;       // p_c: this part of the largest colour difference ...
constexpr double kSmallErrorsShare = 0.95; // p_t: ... takes this part of the scale
constexpr double kFeatureWidthDegrees = 0.082; // w

/// Red, green and blue of sRGB, linear, to CIE XYZ. Source: IEC 61966-2-1.
const glm::dmat3 kXyzFromLinear = glm::transpose(glm::dmat3(
    10135552.0 / 24577794.0,
    8788810.0 / 24577794.0,
    4435075.0 / 24577794.0,
    2613072.0 / 12288897.0,
    8788810.0 / 12288897.0,
    887015.0 / 12288897.0,
    1425312.0 / 73733382.0,
    8788810.0 / 73733382.0,
    70074185.0 / 73733382.0));
const glm::dvec3 kWhite = kXyzFromLinear * glm::dvec3(1.0);
const glm::dmat3 kLinearFromXyz = glm::inverse(kXyzFromLinear);

double linear_from_srgb(std::uint8_t byte) {
    const double value = byte / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The opponent space in which the eye's sensitivity to detail is known: luminance, red to green,
/// blue to yellow; linear in light.
glm::dvec3 opponent_from_linear(const glm::dvec3& linear) {
    const glm::dvec3 xyz = kXyzFromLinear * linear / kWhite;
    return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 linear_from_opponent(const glm::dvec3& opponent) {
    const double y = (opponent.x + 16.0) / 116.0;
    return kLinearFromXyz
           * (kWhite * glm::dvec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0));
}

/// CIE L*a*b*, with colours fainter where it is dark (the Hunt effect).
glm::dvec3 perceived_from_linear(const glm::dvec3& linear) {
    constexpr double kBend = 6.0 / 29.0;
    const auto bent = [](double t) {
        return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3.0 * kBend * kBend) + 4.0 / 29.0;
    };
    const glm::dvec3 xyz = kXyzFromLinear * linear / kWhite;
    const double lightness = 116.0 * bent(xyz.y) - 16.0;
    const double faintness = 0.01 * lightness;
    return {
        lightness,
        faintness * 500.0 * (bent(xyz.x) - bent(xyz.y)),
        faintness * 200.0 * (bent(xyz.y) - bent(xyz.z))};
}

/// For large differences: lightness and colour each for itself, then added.
double hybrid_distance(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b;
    return std::abs(d.x) + std::hypot(d.y, d.z);
}

/// To 0 .. 1, with most of the scale for small differences.
double color_error(const glm::dvec3& a, const glm::dvec3& b) {
    static const double kLargest = std::pow(
        hybrid_distance(
            perceived_from_linear({0.0, 1.0, 0.0}), perceived_from_linear({0.0, 0.0, 1.0})),
        kColorExponent);
    const double difference = std::pow(hybrid_distance(a, b), kColorExponent);
    const double small = kSmallErrors * kLargest;
    if (difference < small) return kSmallErrorsShare / small * difference;
    return std::min(
        1.0,
        kSmallErrorsShare + (difference - small) / (kLargest - small) * (1.0 - kSmallErrorsShare));
}

/// The eye's sensitivity to detail in one channel, as a sum of two bells a sqrt(pi / b)
/// exp(-pi^2 x^2 / b), x in degrees.
struct Sensitivity {
    std::array<double, 2> a;
    std::array<double, 2> b;
};

constexpr std::array<Sensitivity, 3> kSensitivity = {{
    {{1.0, 0.0}, {0.0047, 1e-5}},
    {{1.0, 0.0}, {0.0053, 1e-5}},
    {{34.1, 13.5}, {0.04, 0.025}},
}};
constexpr double kWidestBell = 0.04;

Plane blurred(const Plane& plane, const Sensitivity& sensitivity, double pixels_per_degree) {
    const double pi = std::numbers::pi;
    const int radius = static_cast<int>(
        std::ceil(3.0 * std::sqrt(kWidestBell / (2.0 * pi * pi)) * pixels_per_degree));
    Plane sum{plane.width, plane.height, std::vector<float>(plane.values.size())};
    std::array<Kernel, 2> kernels;
    std::array<double, 2> weights = {};
    for (std::size_t bell = 0; bell < 2; ++bell) {
        const double b = sensitivity.b[bell];
        kernels[bell] = kernel(radius, [&](double x) {
            const double degrees = x / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / b);
        });
        double area = 0.0;
        for (const float weight : kernels[bell])
            area += static_cast<double>(weight);
        weights[bell] = sensitivity.a[bell] * std::sqrt(pi / b) * area * area;
    }
    for (std::size_t bell = 0; bell < 2; ++bell) {
        if (weights[bell] == 0.0) continue;
        const Kernel along = normalised(kernels[bell]);
        const Plane part = filtered(plane, along, along);
        const auto share = static_cast<float>(weights[bell] / (weights[0] + weights[1]));
        for (std::size_t i = 0; i < sum.values.size(); ++i)
            sum.values[i] += share * part.values[i];
    }
    return sum;
}

/// Edges and points of a picture: the length of its first and of its second derivatives at every
/// pixel.
struct Features {
    std::vector<float> edges;
    std::vector<float> points;
};

Features find_features(const Plane& luminance, double pixels_per_degree) {
    const double sigma = 0.5 * kFeatureWidthDegrees * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const auto bell = [&](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); };
    const Kernel smooth = normalised(kernel(radius, bell));
    const auto length = [&](const Kernel& derivative) {
        const Plane x = filtered(luminance, derivative, smooth);
        const Plane y = filtered(luminance, smooth, derivative);
        std::vector<float> lengths(x.values.size());
        for (std::size_t i = 0; i < lengths.size(); ++i)
            lengths[i] = std::hypot(x.values[i], y.values[i]);
        return lengths;
    };
    return {
        length(normalised(kernel(radius, [&](double x) { return -x * bell(x); }))),
        length(normalised(
            kernel(radius, [&](double x) { return (x * x / (sigma * sigma) - 1.0) * bell(x); })))};
}

/// What is compared of one picture.
struct Seen {
    std::vector<glm::dvec3> colors; ///< L*a*b* with the Hunt effect
    Features features;
};

Seen seen(const engine::Image& picture, double pixels_per_degree) {
    std::array<double, 256> linear{};
    for (std::size_t byte = 0; byte < linear.size(); ++byte)
        linear[byte] = linear_from_srgb(static_cast<std::uint8_t>(byte));
    const std::size_t count = picture.pixel_count();
    Plane empty{picture.width, picture.height, std::vector<float>(count)};
    std::array<Plane, 3> channels = {empty, empty, empty};
    Plane luminance = empty;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* pixel =
            picture.bytes.data() + i * static_cast<std::size_t>(picture.channels);
        const glm::dvec3 opponent =
            opponent_from_linear({linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]});
        for (int channel = 0; channel < 3; ++channel)
            channels[static_cast<std::size_t>(channel)].values[i] =
                static_cast<float>(opponent[channel]);
        luminance.values[i] = static_cast<float>((opponent.x + 16.0) / 116.0);
    }
    for (std::size_t channel = 0; channel < 3; ++channel)
        channels[channel] = blurred(channels[channel], kSensitivity[channel], pixels_per_degree);
    Seen result;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 opponent(
            channels[0].values[i], channels[1].values[i], channels[2].values[i]);
        result.colors.push_back(
            perceived_from_linear(glm::clamp(linear_from_opponent(opponent), 0.0, 1.0)));
    }
    result.features = find_features(luminance, pixels_per_degree);
    return result;
}

} // namespace

std::vector<float>
flip(const engine::Image& picture_a, const engine::Image& picture_b, double pixels_per_degree) {
    CHECK_EQ(picture_a.width, picture_b.width);
    CHECK_EQ(picture_a.height, picture_b.height);
    CHECK(std::min(picture_a.channels, picture_b.channels) >= 3);
    CHECK(picture_a.pixel_count() > 0);
    const Seen a = seen(picture_a, pixels_per_degree);
    const Seen b = seen(picture_b, pixels_per_degree);
    std::vector<float> difference(a.colors.size());
    for (std::size_t i = 0; i < difference.size(); ++i) {
        const double edges =
            static_cast<double>(std::abs(a.features.edges[i] - b.features.edges[i]));
        const double points =
            static_cast<double>(std::abs(a.features.points[i] - b.features.points[i]));
        const double features =
            std::pow(std::max(edges, points) / std::numbers::sqrt2, kFeatureExponent);
        difference[i] = static_cast<float>(
            std::pow(color_error(a.colors[i], b.colors[i]), 1.0 - std::min(1.0, features)));
    }
    return difference;
}

} // namespace measure
