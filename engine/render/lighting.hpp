// All lights times their masks, plus ambient light, tone mapped and encoded in the same pass.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/render/gbuffer.hpp"
#include "engine/render/light_batches.hpp"

#include <glm/glm.hpp>

#include <span>

namespace render {

/// What light becomes on the picture.
struct Exposure {
    glm::vec3 ambient = {0.2F, 0.2F, 0.2F}; ///< after exposure: a white surface shows this much
    float scale = 1.0F;                     ///< exposed light per (illuminance * albedo / pi)
};

/// The exposure under which white surfaces that face the strongest light show 0.8 of it, where a
/// level sets none. Spot and point lights count at a quarter of their range, or at 3 m.
float default_exposure(std::span<const scene::PlacedLight> lights);

/// Draws lighting batches, one after the other.
class Lighting {
public:
    Lighting();

    /// What one batch adds, on top of what earlier batches of the frame left in `target`.
    struct Pass {
        const LightBatch& batch;
        const scene::CameraView& camera;
        std::span<const scene::PlacedLight> lights; ///< of the frame
        Exposure exposure;
        const gpu::Texture*
            masks; ///< array of MAX_MASK_LAYERS or fewer; null when the batch has none
        const gpu::Texture*
            earlier; ///< rgba16f with the light of earlier batches; null for the first
        bool last;   ///< tone maps and encodes
    };

    /// Errors: a shader that does not compile.
    engine::Result<void> draw(
        gpu::Frame& frame,
        gpu::ShaderLibrary& shaders,
        const GBuffer& gbuffer,
        const gpu::Framebuffer& target,
        const Pass& pass);

private:
    gpu::Buffer constants_;
    gpu::Buffer tiles_;
    gpu::VertexArray vertices_;
};

} // namespace render
