// How far a model reaches when scales and translations multiply down its tree.

#include "engine/scene/gltf_reader.hpp"

#include <algorithm>
#include <cmath>

namespace scene {

namespace {

/// Powers of a float's range, so that joint matrices and their products with positions stay finite.
constexpr double kMaxScale = 1e12;
constexpr double kMaxDistance = 1e15;

struct Reach {
    double scale = 1.0;    ///< largest stretch of a vector
    double distance = 0.0; ///< largest distance from the origin
};

/// The largest number that a channel can give. Hermite blends add at most 8/27 of the longest
/// tangent.
double largest_value(const AnimationChannel& channel) {
    double largest = 0.0;
    for (const float value : channel.values)
        largest = std::max(largest, std::abs(static_cast<double>(value)));
    double longest = 0.0;
    for (std::size_t i = 1; i < channel.times.size(); ++i)
        longest = std::max(
            longest,
            static_cast<double>(channel.times[i]) - static_cast<double>(channel.times[i - 1]));
    return channel.interpolation == Interpolation::cubic_spline ? largest * (1.0 + 0.3 * longest)
                                                                : largest;
}

/// Of each node in its parent, whatever plays.
std::vector<Reach> own_reaches(const Model& model) {
    std::vector<Reach> reaches;
    for (const Node& node : model.nodes) {
        const glm::dvec3 scale = glm::abs(glm::dvec3(node.local.scale));
        reaches.push_back(
            {std::max({scale.x, scale.y, scale.z}), glm::length(node.local.position)});
    }
    for (const AnimationClip& clip : model.clips) {
        for (const AnimationChannel& channel : clip.channels) {
            Reach& reach = reaches[channel.node];
            if (channel.property == AnimatedProperty::scale)
                reach.scale = std::max(reach.scale, largest_value(channel));
            if (channel.property == AnimatedProperty::translation)
                reach.distance = std::max(reach.distance, std::sqrt(3.0) * largest_value(channel));
        }
    }
    return reaches;
}

} // namespace

engine::Result<void> check_reach(const Model& model) {
    std::vector<Reach> reaches = own_reaches(model);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        const Reach above = node.parent ? reaches[*node.parent] : Reach{};
        Reach& reach = reaches[i];
        reach = {above.scale * reach.scale, above.distance + above.scale * reach.distance};
        if (reach.scale > kMaxScale || reach.distance > kMaxDistance)
            return engine::Error{fmt::format(
                "node '{}': scales multiply to {:g} and reach {:g} metres, expected at most {:g} "
                "and {:g}",
                node.name,
                reach.scale,
                reach.distance,
                kMaxScale,
                kMaxDistance)};
    }
    return {};
}

} // namespace scene
