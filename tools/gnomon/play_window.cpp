#include "engine/app/window_input.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/window.hpp"
#include "engine/scene/views.hpp"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tools/gnomon/play.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

/// A camera that is flown by hand.
class FlyCamera {
public:
    explicit FlyCamera(scene::CameraView view) : view_(std::move(view)) {
        const glm::vec3 back = view_.world_from_view[2];
        yaw_ = std::atan2(back.x, back.z);
        pitch_ = -std::asin(std::clamp(back.y, -1.0F, 1.0F));
    }

    void move(const app::Input& input, float seconds) {
        constexpr float kSpeed = 4.0F;           // m/s
        constexpr float kTurn = 2.0F;            // rad/s of a stick
        constexpr float kTurnPerPixel = 0.0025F; // rad
        constexpr float kSteepest = 1.55F;
        const glm::vec2 turn = input.pointer_delta_px() * kTurnPerPixel;
        yaw_ -= turn.x + input.axis(app::Axis::right_x) * kTurn * seconds;
        pitch_ = std::clamp(
            pitch_ - turn.y + input.axis(app::Axis::right_y) * kTurn * seconds,
            -kSteepest,
            kSteepest);
        view_.world_from_view = glm::mat3_cast(
            glm::angleAxis(yaw_, glm::vec3(0.0F, 1.0F, 0.0F))
            * glm::angleAxis(pitch_, glm::vec3(1.0F, 0.0F, 0.0F)));
        const glm::vec2 walk = input.walk();
        const float speed = input.down(app::Key::left_shift) ? kSpeed * 4.0F : kSpeed;
        const glm::vec3 step = view_.world_from_view * glm::vec3(walk.x, 0.0F, -walk.y);
        view_.position += glm::dvec3(step * speed * seconds);
    }

    [[nodiscard]] scene::CameraView view(const glm::ivec2& size) const {
        scene::CameraView view = view_;
        view.width = size.x;
        view.height = size.y;
        return view;
    }

private:
    scene::CameraView view_;
    float yaw_ = 0.0F;
    float pitch_ = 0.0F;
};

engine::Result<void>
take_picture(const gpu::Framebuffer& window, const std::filesystem::path& folder, int frame) {
    if (auto made = make_folder(folder); !made) return made;
    const auto file = folder / fmt::format("picture_{:06}.png", frame);
    if (auto written = engine::write_png(file, gpu::read_window(window)); !written) return written;
    fmt::print("{}\n", file.string());
    return {};
}

} // namespace

engine::Result<void>
play_in_window(Level& level, const PlayOptions& options, const glm::ivec2& size) {
    auto made = gpu::make_window_context(
        {.title = "Gnomon: " + level.name, .width = size.x, .height = size.y});
    if (!made) return made.error();
    gpu::Window& window = **made;
    render::Renderer renderer(shadows::shader_folders());
    shadows::ShadowSystem shadows;
    shadows.settings = level.shadows;
    app::WindowInput hands(window.native());
    app::Input input;
    const auto camera = choose_camera(level, options.view.camera, size.x, size.y);
    if (!camera) return camera.error();
    FlyCamera fly(*camera);
    window.capture_pointer(true);
    auto before = std::chrono::steady_clock::now();
    for (int frame = 0;
         !window.should_close() && (options.window_frames == 0 || frame < options.window_frames);
         ++frame) {
        window.poll();
        input.advance(hands.take());
        if (input.pressed(app::Key::escape)) window.request_close();
        const auto now = std::chrono::steady_clock::now();
        const float seconds = std::min(std::chrono::duration<float>(now - before).count(), 0.1F);
        before = now;
        fly.move(input, seconds);
        scene::update(level.world, seconds);
        const glm::ivec2 size_px = window.size_px();
        if (size_px.x == 0 || size_px.y == 0) continue;
        const gpu::Framebuffer target = window.framebuffer();
        const auto drawn = renderer.draw(
            level.world,
            fly.view(size_px),
            scene::placed_lights(level.world),
            &shadows,
            target,
            {.exposure = level.exposure});
        if (!drawn) return drawn;
        if (input.pressed(app::Key::f12) || frame + 1 == options.window_frames)
            if (auto taken = take_picture(target, options.out, frame); !taken) return taken;
        for (const engine::Error& error : renderer.shaders().poll())
            fmt::print(stderr, "{}\n", engine::to_string(error));
        window.set_title(fmt::format(
            "Gnomon: {} | {:.1f} ms", level.name, static_cast<double>(seconds) * 1000.0));
        window.swap();
    }
    return {};
}

} // namespace gnomon
