#include "tools/gnomon/motion_protocols.hpp"

#include "engine/core/check.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/measure/report.hpp"

namespace gnomon {

namespace {

constexpr double kWalkSpeed = 1.4; // m/s
constexpr double kTurnPerFrame = std::numbers::pi / 180.0;
/// From 60 to 50 degrees, whatever it starts from.
constexpr double kZoom = 50.0 / 60.0;

const std::array<Protocol, 8>& all_protocols() {
    static const std::array<Protocol, 8> kAll = {{
        {measure::kStill, "nothing moves", false},
        {"walk", "the camera walks along its view at 1.4 m/s", true},
        {"yaw", "the camera turns to the left by a degree a frame", true},
        {"zoom", "the camera's angle closes to 5/6 of itself, as from 60 to 50 degrees", true},
        {"sun", "directional lights turn by 0.02 degrees a frame", false},
        {"light", "spot and point lights go to the camera's right at 1.4 m/s", false},
        {"casters", "moving casters (or the largest one) run to and fro at 2 m/s", false},
        {"play", "the level as it is played: its own paths, animations and script", false},
    }};
    return kAll;
}

/// Along the view, on the level.
scene::CameraView walked(scene::CameraView camera, int frame) {
    glm::dvec3 forward = -glm::dvec3(camera.world_from_view[2]);
    forward.y = 0.0;
    if (glm::length(forward) < 1e-6)
        forward = glm::dvec3(camera.world_from_view[1]); // looks straight down or up
    camera.position += glm::normalize(forward) * (kWalkSpeed * kFrameSeconds * frame);
    return camera;
}

/// To the left.
scene::CameraView turned(scene::CameraView camera, int frame) {
    const glm::dmat4 turn =
        glm::rotate(glm::dmat4(1.0), kTurnPerFrame * frame, glm::dvec3(0.0, 1.0, 0.0));
    camera.world_from_view = glm::mat3(glm::dmat3(turn) * glm::dmat3(camera.world_from_view));
    return camera;
}

/// By the same angle in every frame.
scene::CameraView zoomed(scene::CameraView camera, int frame, int frame_count) {
    const double part = static_cast<double>(frame) / std::max(1, frame_count - 1);
    camera.fov_y =
        static_cast<float>(static_cast<double>(camera.fov_y) * std::lerp(1.0, kZoom, part));
    return camera;
}

} // namespace

std::span<const Protocol> protocols() {
    return all_protocols();
}

std::vector<std::string> protocol_names() {
    std::vector<std::string> names;
    for (const Protocol& protocol : protocols())
        names.emplace_back(protocol.name);
    return names;
}

const Protocol& find_protocol(std::string_view name) {
    const auto found = std::find_if(
        protocols().begin(), protocols().end(), [&](const Protocol& p) { return p.name == name; });
    CHECK(found != protocols().end());
    return *found;
}

scene::CameraView
camera_at(std::string_view protocol, const scene::CameraView& start, int frame, int frame_count) {
    if (protocol == "walk") return walked(start, frame);
    if (protocol == "yaw") return turned(start, frame);
    if (protocol == "zoom") return zoomed(start, frame, frame_count);
    return start;
}

} // namespace gnomon
