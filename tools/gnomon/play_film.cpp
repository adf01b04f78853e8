#include "tools/gnomon/play_film.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace gnomon {

namespace {

void close_pipe(std::FILE* pipe) {
    static_cast<void>(pclose(pipe));
}

std::FILE* open_pipe(const std::filesystem::path& file, const glm::ivec2& size) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe,cert-env33-c): a fixed command, and nothing else runs
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) return nullptr;
    // Even sides, which the usual chroma needs.
    const std::string command = fmt::format(
        "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s {}x{} -r {} -i - "
        "-vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2' -pix_fmt yuv420p '{}'",
        size.x,
        size.y,
        kFilmFramesPerSecond,
        file.string());
    return popen(command.c_str(), "w"); // NOLINT(cert-env33-c): the path is the user's own
}

} // namespace

Film::Film(const std::filesystem::path& file, const glm::ivec2& size)
    : pipe_(open_pipe(file, size), close_pipe) {}

void Film::add(const engine::Image& frame) const {
    if (pipe_ == nullptr) return;
    for (std::size_t pixel = 0; pixel < frame.pixel_count(); ++pixel)
        std::fwrite(
            frame.bytes.data() + pixel * static_cast<std::size_t>(frame.channels),
            1,
            3,
            pipe_.get());
}

} // namespace gnomon
