#include "engine/scene/animation_clip.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace scene {

namespace {

/// The key at or before `time`, the next one, and how far between them: 0 at the first, 1 at the
/// second.
struct Segment {
    std::size_t before = 0;
    std::size_t after = 0;
    float fraction = 0.0F;
    float seconds = 0.0F; ///< between the keys
};

Segment find_segment(const std::vector<float>& times, float time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return {};
    const auto index = static_cast<std::size_t>(after - times.begin());
    if (after == times.end()) return {index - 1, index - 1, 0.0F, 0.0F};
    const float seconds = times[index] - times[index - 1];
    return {index - 1, index, (time - times[index - 1]) / seconds, seconds};
}

glm::quat read_quaternion(const float* value) {
    return {value[3], value[0], value[1], value[2]};
}

void write_unit_quaternion(glm::quat rotation, const float* fallback, float* out) {
    const float length = glm::length(rotation);
    rotation = length > 1e-6F ? rotation / length : read_quaternion(fallback);
    out[0] = rotation.x;
    out[1] = rotation.y;
    out[2] = rotation.z;
    out[3] = rotation.w;
}

void sample_linear(const AnimationChannel& channel, const Segment& segment, float* out) {
    const float* from = &channel.values[segment.before * channel.width];
    const float* to = &channel.values[segment.after * channel.width];
    if (channel.property == AnimatedProperty::rotation) {
        const glm::quat turned =
            glm::slerp(read_quaternion(from), read_quaternion(to), segment.fraction);
        write_unit_quaternion(turned, from, out);
        return;
    }
    for (std::uint32_t i = 0; i < channel.width; ++i)
        out[i] = glm::mix(from[i], to[i], segment.fraction);
}

void sample_cubic(const AnimationChannel& channel, const Segment& segment, float* out) {
    const std::size_t width = channel.width;
    const float* from = &channel.values[(3 * segment.before + 1) * width];
    const float* out_tangent = from + width;
    const float* in_tangent = &channel.values[3 * segment.after * width];
    const float* to = in_tangent + width;
    const float t = segment.fraction;
    const float t2 = t * t;
    const float t3 = t2 * t;
    for (std::size_t i = 0; i < width; ++i)
        out[i] = (2.0F * t3 - 3.0F * t2 + 1.0F) * from[i]
                 + segment.seconds * (t3 - 2.0F * t2 + t) * out_tangent[i]
                 + (3.0F * t2 - 2.0F * t3) * to[i] + segment.seconds * (t3 - t2) * in_tangent[i];
    if (channel.property == AnimatedProperty::rotation)
        write_unit_quaternion(read_quaternion(out), from, out);
}

} // namespace

void sample(const AnimationChannel& channel, float time, float* out) {
    const Segment segment = find_segment(channel.times, time);
    if (channel.interpolation == Interpolation::cubic_spline) {
        sample_cubic(channel, segment, out);
    } else if (channel.interpolation == Interpolation::linear) {
        sample_linear(channel, segment, out);
    } else {
        std::copy_n(&channel.values[segment.before * channel.width], channel.width, out);
    }
}

} // namespace scene
