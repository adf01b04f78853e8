// A draw list on the device: its instances and commands as buffers, and the vertex array that reads
// them.

#pragma once

#include "engine/gpu/frame.hpp"
#include "engine/render/draw_list.hpp"

namespace render {

class DrawRuns {
public:
    /// @param label prefix of the buffers' names in frame debuggers
    DrawRuns(const std::string& label, const GeometryPool& pool);

    void upload(const DrawList& list);

    /// All commands of one run in one multi-draw. State and textures are the caller's.
    void draw(gpu::Frame& frame, const gpu::Program& program, const DrawList::Run& run) const;

private:
    gpu::Buffer instances_;
    gpu::Buffer commands_;
    gpu::VertexArray vertices_;
};

} // namespace render
