// Cameras and KHR_lights_punctual lights out of glTF.

#include "engine/scene/gltf_reader.hpp"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>

namespace scene {

namespace {

engine::Result<void>
read_camera(GltfReader& reader, const std::string& place, const tinygltf::Camera& source) {
    if (source.type != "perspective") {
        reader.warn(place + ": orthographic cameras are left out");
        reader.cameras.emplace_back();
        return {};
    }
    const auto fov_y =
        bounded(place, "yfov", source.perspective.yfov, 1e-3, glm::pi<double>() - 1e-3);
    if (!fov_y) return fov_y.error();
    const auto near = bounded(place, "znear", source.perspective.znear, 1e-6);
    if (!near) return near.error();
    reader.cameras.emplace_back(static_cast<std::uint32_t>(reader.model.cameras.size()));
    reader.model.cameras.push_back({*fov_y, *near});
    return {};
}

engine::Result<void>
read_cone(const std::string& place, const tinygltf::SpotLight& source, Light& light) {
    const auto outer =
        bounded(place, "outerConeAngle", source.outerConeAngle, 0.0, glm::half_pi<double>() + 1e-6);
    if (!outer) return outer.error();
    const auto inner = bounded(place, "innerConeAngle", source.innerConeAngle, 0.0);
    if (!inner) return inner.error();
    if (*inner >= *outer)
        return engine::Error{fmt::format(
            "{}: inner cone angle {} is not below outer cone angle {}", place, *inner, *outer)};
    // A half-space has no projection: the widest cone here ends one degree before.
    constexpr float kWidest = 1.5533431F;
    light.outer_angle = std::min(*outer, kWidest);
    light.inner_angle = std::min(*inner, light.outer_angle);
    return {};
}

engine::Result<Light> read_light(const std::string& place, const tinygltf::Light& source) {
    Light light;
    if (source.type == "directional")
        light.kind = LightKind::directional;
    else if (source.type == "point")
        light.kind = LightKind::point;
    else if (source.type == "spot")
        light.kind = LightKind::spot;
    else
        return engine::Error{fmt::format("{}: type '{}' is not known", place, source.type)};

    if (!source.color.empty() && source.color.size() != 3)
        return engine::Error{
            fmt::format("{}: a colour of {} numbers, expected 3", place, source.color.size())};
    for (std::size_t i = 0; i < source.color.size(); ++i) {
        const auto value = bounded(place, "color", source.color[i], 0.0);
        if (!value) return value.error();
        light.color[static_cast<int>(i)] = *value;
    }
    const auto intensity = bounded(place, "intensity", source.intensity, 0.0, 1e12);
    if (!intensity) return intensity.error();
    light.intensity = *intensity;
    const auto range = bounded(place, "range", source.range, 0.0, 1e12);
    if (!range) return range.error();
    if (*range > 0.0F) light.range = *range; // the parser gives 0 where the file is silent
    if (light.kind == LightKind::spot)
        if (const auto read = read_cone(place, source.spot, light); !read) return read.error();
    return light;
}

} // namespace

engine::Result<float>
bounded(const std::string& place, const char* property, double value, double low, double high) {
    if (!(value >= low && value <= high))
        return engine::Error{
            fmt::format("{}: {} is {}, expected {:g} to {:g}", place, property, value, low, high)};
    return static_cast<float>(value);
}

engine::Result<void> read_cameras_and_lights(GltfReader& reader) {
    for (std::size_t i = 0; i < reader.source.cameras.size(); ++i) {
        const tinygltf::Camera& source = reader.source.cameras[i];
        if (const auto read = read_camera(reader, label("camera", i, source.name), source); !read)
            return read.error();
    }
    for (std::size_t i = 0; i < reader.source.lights.size(); ++i) {
        const tinygltf::Light& source = reader.source.lights[i];
        const auto light = read_light(label("light", i, source.name), source);
        if (!light) return light.error();
        reader.model.lights.push_back(*light);
    }
    return {};
}

} // namespace scene
