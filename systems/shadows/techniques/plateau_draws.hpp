// The skirts of plateaus on the device.

#pragma once

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/frame.hpp"
#include "engine/gpu/shader_library.hpp"
#include "systems/shadows/planar_casters.hpp"
#include "systems/shadows/planar_plateaus.hpp"
#include "systems/shadows/shadow_technique.hpp"

#include <shadows/shared/plateaus.h>

#include <map>

namespace shadows {

class PlateauDraws {
public:
    /// Where a receiver's edges are in the list.
    struct Range {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };

    void begin() { edges_.clear(); }
    /// The outlines of a receiver's casters, as the light's centre sees them.
    Range
    append(const ShadowRequest& request, const PlanarCasters& casters, const glm::dvec3& origin);
    engine::Result<void> upload(gpu::ShaderLibrary& shaders);

    /// @param clip_from_origin as PlanarView has it
    void draw(
        gpu::Frame& frame,
        const Range& range,
        const glm::dmat4& clip_from_origin,
        gpu::RenderState state) const;

    [[nodiscard]] std::size_t gpu_bytes() const { return buffer_.capacity_bytes(); }

private:
    std::map<std::uint32_t, CasterSurface> surfaces_; ///< by mesh
    std::vector<PlateauData> edges_;
    gpu::Buffer buffer_ = gpu::Buffer::dynamic("planar/plateaus");
    gpu::VertexArray no_vertices_ = gpu::VertexArray::none();
    const gpu::Program* program_ = nullptr;
};

} // namespace shadows
