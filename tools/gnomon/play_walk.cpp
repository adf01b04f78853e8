#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "tools/gnomon/play.hpp"
#include "tools/gnomon/play_film.hpp"
#include "tools/gnomon/play_visitor.hpp"
#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

constexpr double kFlightSeconds = 8.0;
constexpr double kLongestRound = 180.0; // s
constexpr double kSecondsPerStill = 4.0;
constexpr int kLeastStills = 8;

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
    const bool whole_round = options.walk_seconds <= 0.0;
    const double longest = whole_round ? kLongestRound : options.walk_seconds;
    Visitor visitor(level, size, whole_round ? kFlightSeconds : longest);
    constexpr double kStep = 1.0 / kFilmFramesPerSecond;
    const int frames = std::max(1, static_cast<int>(longest * kFilmFramesPerSecond));
    const int still_every = std::clamp(
        frames / kLeastStills, 1, static_cast<int>(kSecondsPerStill * kFilmFramesPerSecond));
    std::vector<std::string> stills;
    for (int frame = 0; frame < frames && !(whole_round && visitor.rounds() > 0); ++frame) {
        const double seconds = frame == 0 ? 0.0 : kStep;
        advance(level, static_cast<float>(seconds));
        if (auto drawn = studio.draw(level, visitor.advance(seconds)); !drawn) return drawn.error();
        const engine::Image picture = studio.color();
        film.add(picture);
        if (frame % still_every == still_every / 2) {
            stills.push_back(fmt::format("walk_{:04}.png", frame));
            if (auto written = engine::write_png(options.out / stills.back(), picture); !written)
                return written.error();
        }
        fmt::print(stderr, "\r\x1b[K{:.1f} s", frame * kStep);
    }
    fmt::print(stderr, "\n");
    if (visitor.missed() > 0)
        fmt::print(stderr, "warning: {} points of the path were not reached\n", visitor.missed());
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
