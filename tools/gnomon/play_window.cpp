#include "engine/app/first_person.hpp"
#include "engine/app/window_input.hpp"
#include "engine/gpu/probe.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/window.hpp"
#include "engine/scene/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "tools/gnomon/play.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

/// A camera that is flown by hand.
class FlyCamera {
public:
    explicit FlyCamera(scene::CameraView view)
        : view_(std::move(view)),
          look_(app::Look::of(view_.world_from_view)) {}

    void move(const app::Input& input, float seconds) {
        constexpr float kSpeed = 4.0F; // m/s
        look_.turn(input, seconds);
        view_.world_from_view = look_.world_from_view();
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
    app::Look look_;
};

/// The person at the keys: walks where the level has a player, else flies.
class Eyes {
public:
    Eyes(const Level& level, const scene::CameraView& camera)
        : fly_(camera),
          obstacles_(play::standing_triangles(level.world)) {
        if (level.player) person_.emplace(*level.player);
    }

    void move(const app::Input& input, float seconds) {
        if (person_) {
            person_->move(obstacles_, input, static_cast<double>(seconds));
        } else {
            fly_.move(input, seconds);
        }
    }
    [[nodiscard]] scene::CameraView view(const glm::ivec2& size) const {
        return person_ ? person_->view(size) : fly_.view(size);
    }

private:
    FlyCamera fly_;
    play::Obstacles obstacles_;
    std::optional<app::FirstPerson> person_;
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
    shadows.wraps_stencil = gpu::probe_driver().wraps_stencil;
    app::WindowInput hands(window.native());
    app::Input input;
    const auto camera = choose_camera(level, options.view.camera, size.x, size.y);
    if (!camera) return camera.error();
    Eyes eyes(level, *camera);
    window.capture_pointer(true);
    constexpr float kLongestFrame = 0.25F; // s
    auto before = std::chrono::steady_clock::now();
    for (int frame = 0;
         !window.should_close() && (options.window_frames == 0 || frame < options.window_frames);
         ++frame) {
        window.poll();
        input.advance(hands.take());
        if (input.pressed(app::Key::escape)) window.request_close();
        const auto now = std::chrono::steady_clock::now();
        const float passed = std::chrono::duration<float>(now - before).count();
        const float seconds = std::min(passed, kLongestFrame);
        before = now;
        advance(level, seconds);
        eyes.move(input, seconds);
        const glm::ivec2 size_px = window.size_px();
        if (size_px.x == 0 || size_px.y == 0) continue;
        const gpu::Framebuffer target = window.framebuffer();
        const auto drawn = renderer.draw(
            level.world,
            eyes.view(size_px),
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
            "Gnomon: {} | {:.1f} ms", level.name, static_cast<double>(passed) * 1000.0));
        window.swap();
    }
    return {};
}

} // namespace gnomon
