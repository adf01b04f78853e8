// Casters of several receivers on the device, and their projection on a plane.

#pragma once

#include "engine/gpu/shader_library.hpp"
#include "engine/render/draw_runs.hpp"
#include "engine/render/geometry.hpp"
#include "systems/shadows/planar_casters.hpp"
#include "systems/shadows/shadow_technique.hpp"

#include <optional>
#include <span>
#include <string>
#include <unordered_map>

namespace shadows {

/// A position relative to `origin` into clip space, in doubles until the last step.
glm::dmat4 clip_from_origin(const scene::CameraView& camera, const glm::dvec3& origin);

/// One projection.
struct PlanarView {
    glm::dmat4 clip_from_origin = glm::dmat4(1.0); ///< from positions relative to the draws' origin
    PlanarSample sample;                           ///< the point of the light
    float value = 0.0F;                            ///< what each fragment writes
};

class PlanarDraws {
public:
    /// Where a receiver's casters are in the list.
    struct Runs {
        std::size_t first = 0;
        std::size_t count = 0;
        std::uint32_t first_box = 0;
        std::uint32_t box_count = 0;
    };

    engine::Result<void> fetch_programs(gpu::ShaderLibrary& shaders, const Remedies& remedies);
    /// Starts a new list. @param origin of the instances' positions, world space
    void begin(const render::Geometry& geometry, const LightView& light, const glm::dvec3& origin);
    Runs append(const PlanarCasters& casters, const render::Geometry& geometry);
    void upload(const render::Geometry& geometry);

    /// Draws the shadows of a receiver's casters. @param state all but the culling
    void
    draw(gpu::Frame& frame, const PlanarView& view, const Runs& runs, gpu::RenderState state) const;

    [[nodiscard]] const glm::dvec3& origin() const { return origin_; }
    [[nodiscard]] std::size_t gpu_bytes() const;

private:
    void append_meshes(
        std::span<const std::uint32_t> entities, const render::Geometry& geometry, Runs& runs);
    void make_cube();
    void set_view(const gpu::Program& program, const PlanarView& view) const;
    [[nodiscard]] glm::vec2 height_range(const LitPlane& plane) const;

    LightView light_;
    Remedies remedies_;
    glm::dvec3 origin_ = {};
    render::DrawList list_;
    std::unordered_map<std::uint32_t, std::size_t> item_of_; ///< by entity
    std::optional<render::DrawRuns> draws_;
    std::vector<render::InstanceData> boxes_;
    gpu::Buffer box_instances_;
    gpu::Buffer cube_corners_;
    gpu::Buffer cube_indices_;
    gpu::VertexArray cube_; ///< from -1 to 1, one instance per box
    const render::Textures* textures_ = nullptr;
    const gpu::Program* solid_ = nullptr;
    const gpu::Program* masked_ = nullptr;
};

} // namespace shadows
