// Pictures to a film, by ffmpeg on the other end of a pipe.

#pragma once

#include "engine/core/image.hpp"

#include <glm/glm.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace gnomon {

inline constexpr int kFilmFramesPerSecond = 15;

/// Does nothing where ffmpeg is not installed.
class Film {
public:
    Film(const std::filesystem::path& file, const glm::ivec2& size);

    [[nodiscard]] bool rolling() const { return pipe_ != nullptr; }
    /// @pre as large as the film
    void add(const engine::Image& frame) const;

private:
    std::unique_ptr<std::FILE, void (*)(std::FILE*)> pipe_;
};

} // namespace gnomon
