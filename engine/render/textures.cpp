#include "engine/render/textures.hpp"

#include "engine/core/check.hpp"
#include "engine/gpu/buffer.hpp"

namespace render {

namespace {

gpu::Wrap wrap_of(scene::Wrap wrap) {
    switch (wrap) {
    case scene::Wrap::mirror:
        return gpu::Wrap::mirrored_repeat;
    case scene::Wrap::clamp:
        return gpu::Wrap::clamp_to_edge;
    case scene::Wrap::repeat:
        break;
    }
    return gpu::Wrap::repeat;
}

/// Rows stay in the picture's order: glTF's texture coordinates count from the top, and row 0 lies
/// at v = 0.
gpu::Texture make_texture(const scene::Texture& picture) {
    CHECK_EQ(picture.image.channels, 4);
    const gpu::Filter filter = picture.nearest ? gpu::Filter::nearest : gpu::Filter::linear;
    gpu::TextureDescription description;
    description.format = gpu::Format::srgb8_alpha8;
    description.width = picture.image.width;
    description.height = picture.image.height;
    description.levels = 0;
    description.sampling = {
        .min = filter,
        .mag = filter,
        .mip = picture.nearest ? gpu::MipFilter::nearest : gpu::MipFilter::linear,
        .wrap = wrap_of(picture.wrap_u),
        .wrap_v = wrap_of(picture.wrap_v)};
    gpu::Texture texture("texture/" + picture.name, description);
    texture.upload(gpu::bytes_of(picture.image.bytes));
    texture.make_mip_levels();
    return texture;
}

} // namespace

void Textures::sync(const scene::Assets& assets) {
    for (std::size_t index = textures_.size(); index < assets.textures.size(); ++index)
        textures_.push_back(make_texture(assets.textures[index]));
}

} // namespace render
