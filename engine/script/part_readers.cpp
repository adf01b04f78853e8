#include "engine/script/part_readers.hpp"

#include "engine/scene/framing.hpp"
#include "engine/scene/turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace script {

namespace {

std::string read_name(TableReader& reader) {
    std::string name = reader.text("name").value_or("");
    if (!name.empty()) reader.call_it(name);
    return name;
}

template <class Number>
std::optional<float> to_float(const std::optional<Number>& number) {
    return number ? std::optional(static_cast<float>(*number)) : std::nullopt;
}

float radians(double degrees) {
    return static_cast<float>(glm::radians(degrees));
}

/// The fields that every table of wishes has.
scene::ShadowWish read_wish(TableReader& reader) {
    scene::ShadowWish wish;
    wish.technique = reader.text("technique");
    wish.never = reader.words("never");
    wish.error_px = to_float(reader.optional_number("error_px"));
    wish.map_size = reader.optional_integer("map_size");
    wish.filter = reader.text("filter");
    wish.samples = reader.optional_integer("samples");
    wish.cascades = reader.optional_integer("cascades");
    wish.proxy = reader.optional_integer("proxy");
    wish.way = reader.text("way");
    wish.refresh = reader.optional_integer("refresh");
    if (wish.technique && wish.never)
        for (const std::string& never : *wish.never)
            if (never == *wish.technique)
                reader.complain(
                    "never", fmt::format("names \"{}\", which technique asks for", never));
    return wish;
}

/// The orientation of something that looks from `position` along a direction or to a point.
std::optional<glm::quat>
towards(TableReader& reader, std::string_view field, const glm::dvec3& direction) {
    const double length = glm::length(direction);
    if (length > 1e-9) return scene::rotation_along(direction);
    reader.complain(field, field == "direction" ? "has no length" : "is the position itself");
    return std::nullopt;
}

/// x, y, z turns in degrees, yaw after pitch after roll.
glm::quat read_rotation(TableReader& reader) {
    return scene::turned_by(glm::radians(reader.vector("rotation")));
}

void read_light_shadow(TableReader& reader, scene::LightDescription& light) {
    TableReader shadow = reader.table("shadow");
    light.light.casts_shadow = shadow.boolean("casts");
    light.shadow = read_wish(shadow);
    if (light.shadow.cascades && light.light.kind != scene::LightKind::directional)
        shadow.complain("cascades", "is for suns: maps of other lights have none");
    shadow.finish();
}

/// What all lights share; leaves the reader unfinished.
scene::LightDescription read_light(TableReader& reader, scene::LightKind kind) {
    scene::LightDescription description;
    description.name = read_name(reader);
    description.place = reader.subject().place;
    description.light.kind = kind;
    description.light.color = glm::vec3(reader.vector("color"));
    description.light.on = reader.boolean("on");
    read_light_shadow(reader, description);
    return description;
}

/// What spots and lamps share; leaves the reader unfinished.
scene::LightDescription read_local_light(TableReader& reader, scene::LightKind kind) {
    scene::LightDescription description = read_light(reader, kind);
    description.transform.position = reader.vector("position");
    description.light.intensity = static_cast<float>(reader.number("intensity"));
    description.light.radius = static_cast<float>(reader.number("radius"));
    if (const auto range = to_float(reader.optional_number("range")))
        description.light.range = *range;
    return description;
}

/// A shape with its size and colour, or a file, never both and never neither.
void read_body(TableReader& reader, scene::ModelDescription& model) {
    model.file = reader.text("file").value_or("");
    model.shape = reader.text("shape").value_or("");
    const auto size = reader.numbers("size");
    const auto color = reader.numbers("color");
    if (reader.has("file") == reader.has("shape"))
        reader.complain(
            "",
            reader.has("file") ? "has both a file and a shape, expected one of them"
                               : "has neither a file nor a shape, expected one of them");
    if (reader.has("file") && !reader.has("shape")) {
        if (reader.has("size")) reader.complain("size", "is for shapes; files have a scale");
        if (reader.has("color")) reader.complain("color", "is for shapes; files have materials");
        const std::filesystem::path file(model.file);
        if (file.extension() != ".glb" && file.extension() != ".gltf")
            reader.complain(
                "file", fmt::format("is \"{}\", expected a .glb or .gltf file", model.file));
        if (file.is_absolute())
            reader.complain(
                "file",
                fmt::format("is \"{}\", expected a path relative to the level", model.file));
    }
    if (size) {
        model.size = glm::vec3((*size)[0], size->size() == 3 ? (*size)[1] : 1.0, size->back());
        if (size->size() == 2 && model.shape != "plane" && !model.shape.empty())
            reader.complain("size", fmt::format("has 2 values, expected 3 for a {}", model.shape));
        if (model.shape == "torus" && model.size.y * 2.0F >= model.size.x)
            reader.complain(
                "size", "has a y (thickness) of half its x or more: the torus has no hole");
    } else if (model.shape == "torus") {
        model.size = {1.0F, 0.25F, 1.0F};
    }
    if (model.shape.empty()) return;
    model.color = glm::vec4(
        color ? glm::vec3((*color)[0], (*color)[1], (*color)[2])
              : glm::vec3(reader.default_vector("color")),
        1.0F);
}

/// How a model goes along a path.
void read_way(TableReader& reader, scene::ModelDescription& model) {
    model.path = reader.text("path");
    model.path_speed = static_cast<float>(reader.number("path_speed"));
    model.path_start = static_cast<float>(reader.number("path_start"));
    if (!model.path) return;
    for (const char* field : {"position", "rotation"})
        if (reader.has(field)) reader.complain(field, "is said besides path, which decides it");
}

} // namespace

scene::ShadowWish read_shadow(TableReader& reader) {
    TableReader shadow = reader.table("shadow");
    scene::ShadowWish wish = read_wish(shadow);
    shadow.finish();
    return wish;
}

scene::LightDescription read_sun(TableReader& reader) {
    scene::LightDescription description = read_light(reader, scene::LightKind::directional);
    description.light.intensity = static_cast<float>(reader.number("illuminance"));
    description.light.angular_radius = radians(reader.number("angular_size") / 2.0);
    if (const auto rotation = towards(reader, "direction", reader.vector("direction")))
        description.transform.rotation = *rotation;
    reader.finish();
    return description;
}

scene::LightDescription read_spot(TableReader& reader) {
    scene::LightDescription description = read_local_light(reader, scene::LightKind::spot);
    description.light.outer_angle = radians(reader.number("outer_angle"));
    description.light.inner_angle = radians(reader.number("inner_angle"));
    if (description.light.inner_angle >= description.light.outer_angle)
        reader.complain("inner_angle", "is not less than outer_angle");

    const glm::dvec3 direction = reader.vector("direction");
    const glm::dvec3 target = reader.vector("target");
    const bool aims = reader.has("target");
    if (aims && reader.has("direction"))
        reader.complain("target", "is said besides direction, expected one of them");
    const auto rotation = aims ? towards(reader, "target", target - description.transform.position)
                               : towards(reader, "direction", direction);
    if (rotation) description.transform.rotation = *rotation;
    reader.finish();
    return description;
}

scene::LightDescription read_lamp(TableReader& reader) {
    scene::LightDescription description = read_local_light(reader, scene::LightKind::point);
    reader.finish();
    return description;
}

scene::ModelDescription read_model(TableReader& reader) {
    scene::ModelDescription model;
    model.name = read_name(reader);
    model.place = reader.subject().place;
    read_body(reader, model);
    model.transform.position = reader.vector("position");
    model.transform.rotation = read_rotation(reader);
    model.transform.scale = glm::vec3(reader.vector("scale"));
    if (model.transform.scale.x * model.transform.scale.y * model.transform.scale.z == 0.0F)
        reader.complain("scale", "has a factor 0, expected none: the model would have no volume");
    read_way(reader, model);
    model.casts = reader.boolean("casts");
    model.receives = reader.boolean("receives");
    model.hero = reader.boolean("hero");
    model.animation = reader.text("animation");
    model.animation_speed = static_cast<float>(reader.number("animation_speed"));
    model.animation_start = static_cast<float>(reader.number("animation_start"));
    if (model.animation && !model.shape.empty())
        reader.complain("animation", "is for files; shapes stand still");
    model.shadow = read_shadow(reader);
    reader.finish();
    return model;
}

scene::CameraDescription read_camera(TableReader& reader) {
    scene::CameraDescription camera;
    camera.name = read_name(reader);
    camera.place = reader.subject().place;
    camera.camera.fov_y = radians(reader.number("fov"));
    camera.camera.near = static_cast<float>(reader.number("near"));
    camera.transform.position = reader.vector("position");
    const glm::dvec3 look_at = reader.vector("look_at");
    camera.transform.rotation = read_rotation(reader);
    if (reader.has("rotation") && reader.has("look_at"))
        reader.complain("rotation", "is said besides look_at, expected one of them");
    if (!reader.has("rotation"))
        if (const auto rotation = towards(reader, "look_at", look_at - camera.transform.position))
            camera.transform.rotation = *rotation;
    reader.finish();
    return camera;
}

scene::RuleDescription read_rule(TableReader& reader) {
    scene::RuleDescription rule;
    rule.place = reader.subject().place;
    rule.light = reader.text("light");
    rule.receiver = reader.text("receiver");
    rule.caster = reader.text("caster");
    rule.distance = to_float(reader.optional_number("distance"));
    rule.shadow = read_wish(reader);
    bool says_something = false;
    for (const char* field :
         {"technique",
          "never",
          "error_px",
          "map_size",
          "filter",
          "samples",
          "cascades",
          "proxy",
          "way",
          "refresh"})
        says_something = says_something || reader.has(field);
    if (!says_something)
        reader.complain(
            "", "asks for nothing; expected a technique, never, error_px or another wish");
    reader.finish();
    return rule;
}

scene::PathDescription read_path(TableReader& reader) {
    scene::PathDescription path;
    path.name = read_name(reader);
    path.place = reader.subject().place;
    path.points = reader.points("points");
    path.closed = reader.boolean("closed");
    if (!reader.has("points")) reader.complain("points", "is missing, expected two or more places");
    const auto differs = [&](const glm::dvec3& point) { return point != path.points.front(); };
    if (!path.points.empty() && std::none_of(path.points.begin(), path.points.end(), differs))
        reader.complain("points", "are all the same place, expected a way");
    reader.finish();
    return path;
}

scene::PlayerDescription read_player(TableReader& reader) {
    scene::PlayerDescription player;
    player.place = reader.subject().place;
    player.position = reader.vector("position");
    player.heading = radians(reader.number("heading"));
    player.speed = static_cast<float>(reader.number("speed"));
    player.path = reader.text("path");
    reader.finish();
    return player;
}

} // namespace script
