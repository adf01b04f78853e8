// The shadow texture of one group of casters, from one point, and the look into it.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/render/geometry.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/textures/texture_view.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace shadows {

/// What textures are made from; shared by all that have the same size.
class TextureSamples {
public:
    struct Samples {
        gpu::Texture depth;
        gpu::Framebuffer target;
    };

    /// @param layer 0 for casters, 1 for what catches their shadows
    engine::Result<const Samples*> get(int size, int layer);
    [[nodiscard]] std::size_t gpu_bytes() const;

private:
    std::map<std::pair<int, int>, Samples> by_size_;
};

class CasterTexture {
public:
    /// Fits the texture to a group, and notes whether it has to be drawn again.
    /// @param light without a size
    /// Errors: as fit_texture() has them.
    engine::Result<void> update(
        const ShadowRequest& request, const LightView& light, const CasterGroup& casters, int size);

    /// Draws the texture if it has to be.
    engine::Result<void> render(
        gpu::Frame& frame,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry,
        TextureSamples& samples);

    /// Whether things that receive without casting end its shadows.
    [[nodiscard]] bool catches() const { return !drawn_from_.catchers.empty(); }
    /// What the program that looks into it is compiled with; CAUGHT, too, where some do.
    [[nodiscard]] gpu::Defines mask_defines() const;
    /// Finds what is behind the casters. @pre a pass on the mask or on a sum is open, G-buffer and
    /// receivers are bound
    /// @param state but for its scissor
    void look_up(
        gpu::Frame& frame,
        const gpu::Program& mask,
        const scene::CameraView& camera,
        std::span<const gpu::Rect> areas,
        gpu::RenderState state) const;

    [[nodiscard]] const TextureView& view() const { return drawn_from_.view; }
    [[nodiscard]] int size() const { return drawn_from_.size; }
    [[nodiscard]] std::size_t gpu_bytes() const { return texture_.size_bytes(); }

private:
    /// A mesh of the texture, where it was.
    struct Placed {
        std::uint32_t entity = 0;
        glm::dmat4 world_from_mesh = glm::dmat4(1.0);
        bool operator==(const Placed&) const = default;
    };
    /// All that the texture depends on.
    struct DrawnFrom {
        TextureView view;
        int size = 0;
        std::vector<Placed> casters;  ///< by entity, rising
        std::vector<Placed> catchers; ///< what receives without casting, behind the casters
        std::uint64_t poses = 0;      ///< version of the deformed ones; 0 without any
        bool operator==(const DrawnFrom& other) const;
    };

    engine::Result<void> draw_samples(
        gpu::Frame& frame,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& geometry,
        const gpu::Framebuffer& target,
        const std::vector<Placed>& what,
        const std::string& fragment) const;
    engine::Result<void> reduce(
        gpu::Frame& frame,
        gpu::ShaderLibrary& shaders,
        const gpu::Texture& casters,
        const gpu::Texture* catchers);

    LightView light_;
    Remedies remedies_;
    glm::dvec3 origin_ = {}; ///< of the instances
    DrawnFrom drawn_from_;
    bool due_ = true;
    gpu::Texture texture_;
    gpu::Framebuffer target_;
};

} // namespace shadows
