#include "engine/trace/alpha_mask.hpp"

#include "engine/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace trace {
namespace {

/// The texel that stands for index i of a row of `size` texels.
std::int64_t wrapped(std::int64_t i, std::int64_t size, scene::Wrap wrap) {
    if (wrap == scene::Wrap::clamp) return std::clamp<std::int64_t>(i, 0, size - 1);
    const std::int64_t period = wrap == scene::Wrap::mirror ? 2 * size : size;
    const std::int64_t at = ((i % period) + period) % period;
    return at < size ? at : period - 1 - at;
}

/// Keeps texture coordinates in the range where doubles still tell texels apart.
double bounded(double texels) {
    return std::clamp(texels, -1e15, 1e15);
}

} // namespace

AlphaMask::AlphaMask(const scene::Material& material, std::span<const scene::Texture> textures)
    : factor_(static_cast<double>(material.base_color.a)),
      cutoff_(static_cast<double>(material.alpha_cutoff)) {
    CHECK(material.alpha_masked);
    if (material.texture == scene::kNoTexture) return;
    CHECK_LT(material.texture, textures.size());
    const scene::Texture& texture = textures[material.texture];
    CHECK_EQ(texture.image.channels, 4);
    width_ = texture.image.width;
    height_ = texture.image.height;
    wrap_u_ = texture.wrap_u;
    wrap_v_ = texture.wrap_v;
    nearest_ = texture.nearest;
    alpha_.reserve(texture.image.pixel_count());
    for (std::size_t pixel = 0; pixel < texture.image.pixel_count(); ++pixel)
        alpha_.push_back(texture.image.bytes[4 * pixel + 3]);
}

bool AlphaMask::hole_at(const glm::dvec2& uv) const {
    const double alpha = width_ == 0 ? 1.0 : sample(uv);
    return alpha * factor_ < cutoff_;
}

double AlphaMask::texel(std::int64_t x, std::int64_t y) const {
    const auto column = static_cast<std::size_t>(wrapped(x, width_, wrap_u_));
    const auto row = static_cast<std::size_t>(wrapped(y, height_, wrap_v_));
    return alpha_[row * static_cast<std::size_t>(width_) + column] / 255.0;
}

double AlphaMask::sample(const glm::dvec2& uv) const {
    const double shift = nearest_ ? 0.0 : 0.5; // texel centres stand at halves
    const double x = bounded(uv.x * width_) - shift;
    const double y = bounded(uv.y * height_) - shift;
    const auto column = static_cast<std::int64_t>(std::floor(x));
    const auto row = static_cast<std::int64_t>(std::floor(y));
    if (nearest_) return texel(column, row);
    const double along = x - std::floor(x);
    const double down = y - std::floor(y);
    const double upper = glm::mix(texel(column, row), texel(column + 1, row), along);
    const double lower = glm::mix(texel(column, row + 1), texel(column + 1, row + 1), along);
    return glm::mix(upper, lower, down);
}

} // namespace trace
