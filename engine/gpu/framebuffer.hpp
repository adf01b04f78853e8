// What a pass draws into: layers of textures, or the window.

#pragma once

#include "engine/core/result.hpp"
#include "engine/gpu/handle.hpp"
#include "engine/gpu/texture.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace gpu {

inline constexpr int kAllLayers = -1;

/// One level of a texture: one layer (cube * 6 + face of cubes), or all of them for layered
/// drawing.
struct Attachment {
    const Texture* texture = nullptr; ///< must outlive the framebuffer's last use
    int level = 0;
    int layer = 0; ///< or kAllLayers
};

struct FramebufferDescription {
    std::vector<Attachment> colors = {};  ///< at the locations 0, 1, ... of the fragment shader
    std::optional<Attachment> depth = {}; ///< depth, with stencil where the format has it
};

/// Cheap to make and to keep; owns no texture.
class Framebuffer {
public:
    Framebuffer() = default;

    /// Errors: the driver does not draw into this set of textures; the sentence says why.
    static engine::Result<Framebuffer>
    make(std::string_view label, const FramebufferDescription& description);

    /// The window's own, colour only is promised. Size in pixels, not in screen units.
    static Framebuffer window(int width, int height);

    [[nodiscard]] GLuint name() const { return handle_.name(); } ///< 0 is the window
    [[nodiscard]] int width() const { return width_; }           ///< of the smallest attachment
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] Rect whole() const { return {0, 0, width_, height_}; }
    [[nodiscard]] const std::vector<Format>& color_formats() const { return color_formats_; }

private:
    FramebufferHandle handle_;
    int width_ = 0;
    int height_ = 0;
    std::vector<Format> color_formats_;
};

} // namespace gpu
