#include "engine/gpu/framebuffer.hpp"

#include "engine/core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gpu {

namespace {

void attach(GLuint framebuffer, GLenum point, const Attachment& attachment) {
    CHECK(attachment.texture != nullptr);
    const Texture& texture = *attachment.texture;
    if (attachment.layer == kAllLayers || texture.description().kind == TextureKind::plane) {
        glNamedFramebufferTexture(framebuffer, point, texture.name(), attachment.level);
    } else {
        CHECK_LT(attachment.layer, texture.layers());
        glNamedFramebufferTextureLayer(
            framebuffer, point, texture.name(), attachment.level, attachment.layer);
    }
}

/// What the driver objects to, as the end of a sentence.
std::string_view reason(GLenum status) {
    switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
        return "one attachment has a format that cannot be drawn into, or no such level or layer";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return "it has no attachment";
    case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
        return "some attachments are layered and others are not";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
        return "the sample counts differ";
    case GL_FRAMEBUFFER_UNSUPPORTED:
        return "this driver does not support these formats together";
    default:
        return "the driver gives no reason";
    }
}

} // namespace

engine::Result<Framebuffer>
Framebuffer::make(std::string_view label, const FramebufferDescription& description) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    Framebuffer framebuffer;
    framebuffer.handle_ = FramebufferHandle(name);
    label_object(GL_FRAMEBUFFER, name, label);

    framebuffer.width_ = std::numeric_limits<int>::max();
    framebuffer.height_ = std::numeric_limits<int>::max();
    const auto shrink_to = [&framebuffer](const Attachment& attachment) {
        const int level = attachment.level;
        framebuffer.width_ = std::min(framebuffer.width_, attachment.texture->width(level));
        framebuffer.height_ = std::min(framebuffer.height_, attachment.texture->height(level));
    };
    std::vector<GLenum> draw_buffers;
    for (const Attachment& color : description.colors) {
        const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw_buffers.size());
        attach(name, point, color);
        shrink_to(color);
        draw_buffers.push_back(point);
        framebuffer.color_formats_.push_back(color.texture->format());
    }
    glNamedFramebufferDrawBuffers(
        name, static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
    if (description.depth) {
        const FormatTraits& format_traits = traits(description.depth->texture->format());
        CHECK(format_traits.depth);
        attach(
            name,
            format_traits.stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
            *description.depth);
        shrink_to(*description.depth);
    }

    const GLenum status = glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        return engine::Error{fmt::format(
            "framebuffer '{}' cannot be drawn into: {} (status {:#x})",
            label,
            reason(status),
            status)};
    }
    return framebuffer;
}

Framebuffer Framebuffer::window(int width, int height) {
    Framebuffer framebuffer;
    framebuffer.width_ = width;
    framebuffer.height_ = height;
    framebuffer.color_formats_ = {Format::rgba8};
    return framebuffer;
}

} // namespace gpu
