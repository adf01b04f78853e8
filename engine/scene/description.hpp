// A level as data: what a Lua file or a plain glTF file says, checked, before it becomes entities.
// Two descriptions can be compared and diffed by name; nothing here touches a registry.

#pragma once

#include "engine/core/result.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/transform.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace scene {

/// What a designer asked of shadows, at one place (scene, light, receiver, caster or rule). Empty:
/// not said here.
struct ShadowWish {
    std::optional<std::string> technique;          ///< "auto" or the name of one
    std::optional<std::vector<std::string>> never; ///< techniques that must not be picked
    std::optional<float> error_px;                 ///< accepted edge displacement, pixels
    std::optional<int> map_size;                   ///< texels per side
    std::optional<std::string> filter;             ///< "nearest", "bilinear", "pcf", "pcss"
    std::optional<int> samples;                    ///< light samples of soft techniques
    std::optional<int> cascades;
    std::optional<int> proxy; ///< level of simplified casters of volumes; 0: the casters themselves
    std::optional<std::string> way; ///< of its ways of doing it, the one a technique has to take
    std::optional<int> refresh; ///< frames that a map or texture may serve before it is drawn anew

    bool operator==(const ShadowWish&) const = default;
};

struct LightDescription {
    std::string name;
    Light light;
    Transform transform; ///< the light shines along -Z
    ShadowWish shadow;
    engine::SourcePlace place;
};

struct CameraDescription {
    std::string name;
    Camera camera;
    Transform transform;
    engine::SourcePlace place;
};

/// A model file, or one of the primitive shapes.
struct ModelDescription {
    std::string name;
    std::string file;  ///< as written; empty for a shape
    std::string shape; ///< "box", "plane", "sphere", "cylinder", "cone", "torus"; empty for a file
    glm::vec3 size = {1.0F, 1.0F, 1.0F}; ///< of a shape: full extents in metres
    std::optional<glm::vec4> color;      ///< linear; replaces the colour of a shape
    Transform transform;
    bool casts = true;
    bool receives = true;
    bool hero = false;
    std::optional<std::string> animation; ///< name of the clip to play; none: the first one, if any
    float animation_speed = 1.0F;
    float animation_start = 0.0F;    ///< seconds into the clip at which it begins
    std::optional<std::string> path; ///< name of the path that it goes along
    float path_speed = 1.2F;         ///< m/s; negative goes backwards
    float path_start = 0.0F;         ///< share of the path at which it begins, 0 to 1
    ShadowWish shadow;
    engine::SourcePlace place;
};

/// A way through the level, for models and for the player.
struct PathDescription {
    std::string name;
    std::vector<glm::dvec3> points; ///< at least two
    bool closed = true;             ///< false: to and fro
    engine::SourcePlace place;
};

/// Whom the person at the keys is.
struct PlayerDescription {
    glm::dvec3 position = {};        ///< of the feet
    float heading = 0.0F;            ///< turn about y, radians; 0 looks along -z
    float speed = 1.6F;              ///< m/s
    std::optional<std::string> path; ///< what a walk without a person follows
    engine::SourcePlace place;
};

/// A wish for some pairs, casters or distances. Empty names match everything; later rules win.
struct RuleDescription {
    std::optional<std::string> light;
    std::optional<std::string> receiver;
    std::optional<std::string> caster;
    std::optional<float> distance; ///< applies from this distance to the camera on, metres
    ShadowWish shadow;
    engine::SourcePlace place;

    bool operator==(const RuleDescription&) const = default;
};

struct SceneDescription {
    std::string file;
    ShadowWish shadow;              ///< scene-wide; error_px is the scene's budget
    std::optional<float> shadow_ms; ///< accepted sum of predicted shadow work per frame
    glm::vec3 ambient = {0.2F, 0.2F, 0.2F};
    std::optional<float> exposure; ///< none: as render::default_exposure finds it
    std::vector<LightDescription> lights;
    std::vector<CameraDescription> cameras;
    std::vector<ModelDescription> models;
    std::vector<RuleDescription> rules;
    std::vector<PathDescription> paths;
    std::optional<PlayerDescription> player;
    std::vector<std::string> warnings; ///< one sentence each, with its place
};

} // namespace scene
