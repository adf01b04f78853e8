// The person at the keys: walks through a level and sees it from eye height.

#pragma once

#include "engine/app/input.hpp"
#include "engine/app/look.hpp"
#include "engine/play/mover.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/description.hpp"

#include <glm/glm.hpp>

namespace app {

class FirstPerson {
public:
    explicit FirstPerson(const scene::PlayerDescription& player);

    /// One frame. Whoever falls out of the level begins again where it began.
    void move(const play::Obstacles& obstacles, const Input& input, double seconds);

    [[nodiscard]] scene::CameraView view(const glm::ivec2& size_px) const;
    [[nodiscard]] const play::Stance& stance() const { return stance_; }
    [[nodiscard]] const Look& look() const { return look_; }

private:
    scene::PlayerDescription player_;
    play::Body body_;
    play::Stance stance_;
    Look look_;
};

} // namespace app
