#include "tools/gnomon/play_visitor.hpp"

#include "engine/scene/camera_path.hpp"
#include "engine/scene/views.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon {

namespace {

std::vector<scene::CameraView> stops_of(const Level& level, const glm::ivec2& size) {
    std::vector<scene::CameraView> stops;
    for (const std::string& name : scene::camera_names(level.world))
        stops.push_back(*scene::find_camera(level.world, name, size.x, size.y));
    if (stops.empty()) stops.push_back(*choose_camera(level, "", size.x, size.y));
    return stops;
}

/// The path that the level gives its player, or nothing.
const scene::Path* path_of(const Level& level) {
    if (!level.player || !level.player->path) return nullptr;
    const auto& paths = level.world.assets.paths;
    const auto found = std::find_if(paths.begin(), paths.end(), [&](const scene::Path& path) {
        return path.name == *level.player->path;
    });
    return found == paths.end() ? nullptr : &*found;
}

} // namespace

Visitor::Visitor(const Level& level, const glm::ivec2& size, double flight_seconds)
    : size_(size),
      flight_seconds_(flight_seconds),
      stops_(stops_of(level, size)),
      obstacles_(play::standing_triangles(level.world)) {
    const scene::Path* path = path_of(level);
    if (path == nullptr) return;
    person_.emplace(*level.player);
    hands_.emplace(*path);
}

scene::CameraView Visitor::advance(double seconds) {
    time_ += seconds;
    if (!person_)
        return scene::view_along(stops_, std::fmod(time_, flight_seconds_) / flight_seconds_);
    input_.advance(hands_->take(*person_, seconds));
    person_->move(obstacles_, input_, seconds);
    return person_->view(size_);
}

int Visitor::rounds() const {
    return hands_ ? hands_->rounds() : static_cast<int>(time_ / flight_seconds_);
}

} // namespace gnomon
