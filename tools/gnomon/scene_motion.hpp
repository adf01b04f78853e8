// Moves lights or casters of a world by a protocol, and puts them back.

#pragma once

#include "engine/scene/camera.hpp"
#include "engine/scene/world.hpp"

#include <string_view>
#include <vector>

namespace gnomon {

/// What a protocol moves in a world, at any of its frames. As long as it lives the world must not
/// be moved by anything else.
///
/// - sun: every directional light turns by 0.02 degrees a frame round the horizontal axis across
/// its
///   way, so that it rises or sets;
/// - light: every spot and point light goes 1.4 m/s to the camera's right, on the level;
/// - casters: what is moved by paths or animations (when nothing is, the largest caster that does
///   not lie under most of the world) runs 2 m/s to the camera's right, turns back after every 32
///   frames, and so on;
/// - others move nothing.
class SceneMotion {
public:
    SceneMotion(scene::World& world, std::string_view protocol, const scene::CameraView& camera);
    /// Everything is where it was.
    ~SceneMotion();
    SceneMotion(const SceneMotion&) = delete;
    SceneMotion& operator=(const SceneMotion&) = delete;

    /// Places everything as in this frame; frame 0 is how it was found.
    void pose(int frame);

    [[nodiscard]] bool moves_anything() const { return !moved_.empty(); }

private:
    struct Moved {
        ecs::Entity entity;
        scene::Transform found;
        glm::dmat4 world_from_local = glm::dmat4(1.0); ///< as found
        glm::dvec3 axis = {};                          ///< of what turns: unit; else zero
    };

    void add(ecs::Entity entity, const glm::dvec3& axis = {});
    void add_lights(bool directional);
    void add_casters();
    void settle();

    scene::World& world_;
    glm::dvec3 sideways_ = {}; ///< unit, level
    bool to_and_fro_ = false;
    double speed_ = 0.0; ///< m/s
    std::vector<Moved> moved_;
};

} // namespace gnomon
