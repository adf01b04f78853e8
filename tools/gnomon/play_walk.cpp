#include "engine/scene/camera_path.hpp"
#include "engine/scene/views.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "tools/gnomon/play.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

constexpr int kFramesPerSecond = 30;
constexpr int kStillCount = 8;

/// Frames to a film, by ffmpeg on the other end of a pipe. Does nothing where it is not installed.
class Film {
public:
    Film(const std::filesystem::path& file, const glm::ivec2& size)
        : pipe_(open(file, size), close) {}

    [[nodiscard]] bool rolling() const { return pipe_ != nullptr; }
    void add(const engine::Image& frame) const {
        if (pipe_ == nullptr) return;
        for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel)
            std::fwrite(
                frame.bytes.data() + pixel * static_cast<std::size_t>(frame.channels),
                1,
                3,
                pipe_.get());
    }

private:
    static void close(std::FILE* pipe) { static_cast<void>(pclose(pipe)); }

    static std::FILE* open(const std::filesystem::path& file, const glm::ivec2& size) {
        // NOLINTNEXTLINE(concurrency-mt-unsafe,cert-env33-c): a fixed command, and nothing else
        // runs
        if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) return nullptr;
        // Even sides, which the usual chroma needs.
        const std::string command = fmt::format(
            "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s {}x{} -r {} -i - "
            "-vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2' -pix_fmt yuv420p '{}'",
            size.x,
            size.y,
            kFramesPerSecond,
            file.string());
        return popen(command.c_str(), "w"); // NOLINT(cert-env33-c): the path is the user's own
    }

    std::unique_ptr<std::FILE, void (*)(std::FILE*)> pipe_;
};

std::vector<scene::CameraView> stops_of(const Level& level, const glm::ivec2& size) {
    std::vector<scene::CameraView> stops;
    for (const std::string& name : scene::camera_names(level.world))
        stops.push_back(*scene::find_camera(level.world, name, size.x, size.y));
    if (stops.empty()) stops.push_back(*choose_camera(level, "", size.x, size.y));
    return stops;
}

std::string index_page(const Level& level, const std::vector<std::string>& stills, bool film) {
    std::string page = fmt::format(
        "<!doctype html>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
        "<style>:root {{ color-scheme: light dark }} body {{ font-family: sans-serif; margin: 2em "
        "}} "
        "img, video {{ max-width: 100%; margin: .2em }}</style>\n<h1>{0}</h1>\n",
        level.name);
    if (film) page += "<p><video src=\"film.mp4\" controls loop></video></p>\n";
    for (const std::string& still : stills)
        page += fmt::format("<img src=\"{0}\" alt=\"{0}\">\n", still);
    return page;
}

} // namespace

engine::Result<std::string>
walk_through(Studio& studio, Level& level, const PlayOptions& options, const glm::ivec2& size) {
    if (auto made = make_folder(options.out); !made) return made.error();
    const Film film(options.out / "film.mp4", size);
    const auto stops = stops_of(level, size);
    const int frames = static_cast<int>(options.walk_seconds * kFramesPerSecond);
    const int still_every = std::max(1, frames / kStillCount);
    std::vector<std::string> stills;
    for (int frame = 0; frame < frames; ++frame) {
        scene::update(level.world, frame == 0 ? 0.0F : 1.0F / kFramesPerSecond);
        const auto camera =
            scene::view_along(stops, static_cast<double>(frame) / std::max(1, frames - 1));
        if (auto drawn = studio.draw(level, camera); !drawn) return drawn.error();
        const engine::Image picture = studio.color();
        film.add(picture);
        if (frame % still_every == still_every / 2) {
            stills.push_back(fmt::format("walk_{:04}.png", frame));
            if (auto written = engine::write_png(options.out / stills.back(), picture); !written)
                return written.error();
        }
        fmt::print(stderr, "\r\x1b[Kframe {}/{}", frame + 1, frames);
    }
    fmt::print(stderr, "\n");
    if (auto written =
            write_text(options.out / "index.html", index_page(level, stills, film.rolling()));
        !written)
        return written.error();
    return fmt::format(
        "{} pictures{} are in {}; open {}",
        stills.size(),
        film.rolling() ? " and film.mp4" : "",
        options.out.string(),
        (options.out / "index.html").string());
}

} // namespace gnomon
