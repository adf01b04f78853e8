#include "engine/render/draw_runs.hpp"

#include <render/shared/bindings.h>

namespace render {

namespace {

gpu::VertexArray
make_vertices(const std::string& label, const GeometryPool& pool, const gpu::Buffer& instances) {
    using gpu::Component;
    const std::vector<gpu::VertexStream> streams = {
        {&pool.positions(), sizeof(glm::vec3), {{ATTRIBUTE_POSITION, 3, Component::f32, 0}}},
        {&pool.attributes(),
         sizeof(VertexAttributes),
         {{ATTRIBUTE_NORMAL, 4, Component::snorm16, offsetof(VertexAttributes, normal)},
          {ATTRIBUTE_UV, 2, Component::f32, offsetof(VertexAttributes, uv)},
          {ATTRIBUTE_PATCH, 1, Component::u32, offsetof(VertexAttributes, patch)}}},
        {&instances,
         sizeof(InstanceData),
         {{ATTRIBUTE_ROW_0, 4, Component::f32, offsetof(InstanceData, row_0)},
          {ATTRIBUTE_ROW_1, 4, Component::f32, offsetof(InstanceData, row_1)},
          {ATTRIBUTE_ROW_2, 4, Component::f32, offsetof(InstanceData, row_2)},
          {ATTRIBUTE_SURFACE, 4, Component::u32, offsetof(InstanceData, surface)}},
         true}};
    return {label, streams, &pool.indices()};
}

gpu::Primitive primitive_of(scene::Topology topology) {
    switch (topology) {
    case scene::Topology::points:
        return gpu::Primitive::points;
    case scene::Topology::lines:
        return gpu::Primitive::lines;
    case scene::Topology::triangles:
        break;
    }
    return gpu::Primitive::triangles;
}

} // namespace

DrawRuns::DrawRuns(const std::string& label, const GeometryPool& pool)
    : instances_(gpu::Buffer::dynamic(label + "/instances")),
      commands_(gpu::Buffer::dynamic(label + "/commands")),
      vertices_(make_vertices(label, pool, instances_)) {}

void DrawRuns::upload(const DrawList& list) {
    instances_.assign(gpu::bytes_of(list.instances));
    commands_.assign(gpu::bytes_of(list.commands));
}

void DrawRuns::draw(
    gpu::Frame& frame, const gpu::Program& program, const DrawList::Run& run) const {
    const gpu::IndirectRange range{
        &commands_,
        run.first_command,
        run.command_count,
        run.triangles,
        primitive_of(run.bucket.topology)};
    frame.draw_indirect(program, vertices_, range);
}

} // namespace render
