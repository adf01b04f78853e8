// Animations out of glTF: channels whose target and numbers are sound.

#include "engine/scene/gltf_reader.hpp"

#include <algorithm>
#include <cmath>

namespace scene {

namespace {

std::optional<AnimatedProperty> property_of(const std::string& path) {
    if (path == "translation") return AnimatedProperty::translation;
    if (path == "rotation") return AnimatedProperty::rotation;
    if (path == "scale") return AnimatedProperty::scale;
    if (path == "weights") return AnimatedProperty::morph_weights;
    return std::nullopt;
}

std::optional<Interpolation> interpolation_of(const std::string& word) {
    if (word == "STEP") return Interpolation::step;
    if (word == "LINEAR") return Interpolation::linear;
    if (word == "CUBICSPLINE") return Interpolation::cubic_spline;
    return std::nullopt;
}

/// Floats of one value of the property at a node; 0 where the node has nothing of the kind.
std::uint32_t width_of(const GltfReader& reader, AnimatedProperty property, std::uint32_t node) {
    switch (property) {
    case AnimatedProperty::rotation:
        return 4;
    case AnimatedProperty::morph_weights: {
        const auto mesh = reader.model.nodes[node].mesh;
        return mesh ? static_cast<std::uint32_t>(reader.model.meshes[*mesh].morph_targets.size())
                    : 0;
    }
    default:
        return 3;
    }
}

engine::Result<void> check_times(const std::string& place, const std::vector<float>& times) {
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] < 0.0F || (i > 0 && times[i] <= times[i - 1]))
            return engine::Error{
                fmt::format("{}: time {} at key {} does not rise from 0 on", place, times[i], i)};
    return {};
}

/// Makes the rotations of all keys unit quaternions; tangents stay.
engine::Result<void> normalise_rotations(const std::string& place, AnimationChannel& channel) {
    const bool cubic = channel.interpolation == Interpolation::cubic_spline;
    const std::size_t step = cubic ? 12 : 4;
    for (std::size_t i = cubic ? 4 : 0; i < channel.values.size(); i += step) {
        float* value = &channel.values[i];
        const double length = glm::length(glm::dvec4(value[0], value[1], value[2], value[3]));
        if (!(length > 1e-6))
            return engine::Error{
                fmt::format("{}: the rotation of key {} is zero", place, i / step)};
        for (int k = 0; k < 4; ++k)
            value[k] = static_cast<float>(static_cast<double>(value[k]) / length);
    }
    return {};
}

engine::Result<void> read_keys(
    GltfReader& reader,
    const std::string& place,
    const tinygltf::AnimationSampler& source,
    AnimationChannel& channel) {
    const auto interpolation = interpolation_of(source.interpolation);
    if (!interpolation)
        return engine::Error{
            fmt::format("{}: interpolation '{}' is not known", place, source.interpolation)};
    channel.interpolation = *interpolation;
    auto times = reader.accessors.floats(source.input, 1);
    if (!times) return at(place + " times", times.error());
    if (const auto checked = check_times(place, *times); !checked) return checked.error();

    const bool weights = channel.property == AnimatedProperty::morph_weights;
    auto values =
        reader.accessors.floats(source.output, weights ? 1 : static_cast<int>(channel.width));
    if (!values) return at(place + " values", values.error());
    const std::size_t per_key =
        channel.width * (channel.interpolation == Interpolation::cubic_spline ? 3U : 1U);
    if (values->size() != times->size() * per_key)
        return engine::Error{fmt::format(
            "{}: {} numbers for {} keys, expected {}",
            place,
            values->size(),
            times->size(),
            times->size() * per_key)};
    channel.times = std::move(*times);
    channel.values = std::move(*values);
    if (channel.property == AnimatedProperty::rotation) return normalise_rotations(place, channel);
    return {};
}

/// @return none for channels that move nothing here
engine::Result<std::optional<AnimationChannel>> read_channel(
    GltfReader& reader,
    const std::string& place,
    const tinygltf::Animation& animation,
    const tinygltf::AnimationChannel& source) {
    const auto sampler =
        optional_index(place, "sampler", source.sampler, animation.samplers.size());
    if (!sampler) return sampler.error();
    const auto target = optional_index(place, "node", source.target_node, reader.nodes.size());
    if (!target) return target.error();
    const auto property = property_of(source.target_path);
    if (!*sampler || !*target || !property) {
        reader.warn(fmt::format(
            "{}: its target '{}' is not known and is left out", place, source.target_path));
        return std::optional<AnimationChannel>();
    }
    if (!reader.nodes[**target]) return std::optional<AnimationChannel>();

    AnimationChannel channel;
    channel.node = *reader.nodes[**target];
    channel.property = *property;
    channel.width = width_of(reader, *property, channel.node);
    if (channel.width == 0) {
        reader.warn(place + ": moves weights of a node without morph targets and is left out");
        return std::optional<AnimationChannel>();
    }
    if (const auto read = read_keys(reader, place, animation.samplers[**sampler], channel); !read)
        return read.error();
    return std::optional(std::move(channel));
}

} // namespace

engine::Result<void> read_animations(GltfReader& reader) {
    for (std::size_t i = 0; i < reader.source.animations.size(); ++i) {
        const tinygltf::Animation& source = reader.source.animations[i];
        const std::string place = label("animation", i, source.name);
        AnimationClip clip;
        clip.name = source.name.empty() ? place : source.name;
        for (std::size_t k = 0; k < source.channels.size(); ++k) {
            auto channel = read_channel(
                reader, fmt::format("{} channel {}", place, k), source, source.channels[k]);
            if (!channel) return channel.error();
            if (!*channel) continue;
            clip.duration = std::max(clip.duration, (*channel)->times.back());
            clip.channels.push_back(std::move(**channel));
        }
        if (!clip.channels.empty()) reader.model.clips.push_back(std::move(clip));
    }
    return {};
}

} // namespace scene
