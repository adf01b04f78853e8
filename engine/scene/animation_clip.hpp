// Keyframes as data, and what they give at a time.

#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace scene {

enum class AnimatedProperty : std::uint8_t { translation, rotation, scale, morph_weights };
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// One property of one node over time.
struct AnimationChannel {
    std::uint32_t node = 0; ///< index into Model::nodes
    AnimatedProperty property = AnimatedProperty::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;  ///< seconds, strictly rising, at least one
    std::vector<float> values; ///< times.size() * width floats; cubic splines hold in-tangent,
                               ///< value, out-tangent for each key
    std::uint32_t width =
        3; ///< floats per value: 3, 4 (rotation x, y, z, w) or the number of morph targets
};

struct AnimationClip {
    std::string name;
    std::vector<AnimationChannel> channels;
    float duration = 0.0F; ///< seconds: the latest key
};

/// The value of a channel at `time`, held before the first key and after the last. Rotations are
/// unit quaternions.
/// @param out channel.width floats
/// Source: glTF 2.0 specification, appendix C (animation sampler interpolation modes).
void sample(const AnimationChannel& channel, float time, float* out);

} // namespace scene
