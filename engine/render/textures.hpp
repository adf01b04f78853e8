// The pictures of a world's materials on the device.

#pragma once

#include "engine/gpu/texture.hpp"
#include "engine/scene/world.hpp"

#include <vector>

namespace render {

class Textures {
public:
    /// Uploads pictures that are new since the last call, with mip levels.
    void sync(const scene::Assets& assets);

    /// @param texture index into Assets::textures
    [[nodiscard]] const gpu::Texture& get(std::uint32_t texture) const {
        return textures_[texture];
    }

private:
    std::vector<gpu::Texture> textures_;
};

} // namespace render
