// What moves while a sequence is measured, and how. Everything is a function of the frame's number,
// so that a sequence can be drawn again.

#pragma once

#include "engine/scene/camera.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

inline constexpr double kFrameSeconds = 1.0 / 60.0;

struct Protocol {
    std::string_view name;
    std::string_view text;     ///< what moves
    bool moves_camera = false; ///< and nothing else; else the camera stands
};

/// All protocols, "still" first.
std::span<const Protocol> protocols();
std::vector<std::string> protocol_names();
/// @pre one of protocol_names()
const Protocol& find_protocol(std::string_view name);

/// The camera of a frame; `start` where the protocol does not move it.
/// @param frame 0 .. frame_count - 1
scene::CameraView
camera_at(std::string_view protocol, const scene::CameraView& start, int frame, int frame_count);

} // namespace gnomon
