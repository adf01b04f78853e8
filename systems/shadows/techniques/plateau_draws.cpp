#include "systems/shadows/techniques/plateau_draws.hpp"

#include <algorithm>
#include <iterator>

namespace shadows {

namespace {

PlateauData to_data(const PlateauEdge& edge) {
    const auto wide = [](const glm::dvec3& vector) { return glm::vec4(glm::vec3(vector), 0.0F); };
    return {
        wide(edge.from),
        wide(edge.to),
        wide(edge.side_from),
        wide(edge.side_to),
        wide(edge.radius_0),
        wide(edge.radius_1)};
}

} // namespace

PlateauDraws::Range PlateauDraws::append(
    const ShadowRequest& request, const PlanarCasters& casters, const glm::dvec3& origin) {
    const scene::World& world = request.world;
    const LightView& light = request.scene.lights[request.light];
    const auto first = static_cast<std::uint32_t>(edges_.size());
    for (const CasterView& view : request.scene.casters) {
        const auto& served = casters.entities;
        if (std::find(served.begin(), served.end(), view.id) == served.end()) continue;
        const scene::Mesh& mesh = world.assets.meshes[view.mesh];
        auto found = surfaces_.find(view.mesh);
        if (found == surfaces_.end())
            found = surfaces_.emplace(view.mesh, make_caster_surface(mesh)).first;
        const auto* posed = world.registry.try_get<scene::PosedMesh>(ecs::Entity{view.id});
        const auto edges = plateau_edges(
            light,
            casters.plane,
            found->second,
            posed != nullptr ? posed->positions : mesh.positions,
            view.world_from_mesh,
            origin);
        std::transform(edges.begin(), edges.end(), std::back_inserter(edges_), to_data);
    }
    return {first, static_cast<std::uint32_t>(edges_.size()) - first};
}

engine::Result<void> PlateauDraws::upload(gpu::ShaderLibrary& shaders) {
    const auto program = shaders.graphics("shadows/plateau.vert", "shadows/plateau.frag");
    if (!program) return program.error();
    program_ = *program;
    if (!edges_.empty()) buffer_.assign(gpu::bytes_of(edges_));
    return {};
}

void PlateauDraws::draw(
    gpu::Frame& frame,
    const Range& range,
    const glm::dmat4& clip_from_origin,
    gpu::RenderState state) const {
    if (range.count == 0) return;
    state.cull = gpu::Cull::none; // slopes lie on either side of their edge
    program_->set("clip_from_origin", glm::mat4(clip_from_origin));
    program_->set("first_edge", static_cast<int>(range.first));
    buffer_.bind_storage(PLATEAUS_BINDING);
    frame.state(state);
    frame.draw(
        *program_, no_vertices_, {.first = 0, .count = PLATEAU_VERTICES, .instances = range.count});
}

} // namespace shadows
