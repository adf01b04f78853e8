#include "systems/shadows/techniques/map_uniforms.hpp"

namespace shadows {

namespace {

void set_size(const gpu::Program& mask, int size, int border) {
    const auto texels = static_cast<float>(size);
    mask.set("map_size", glm::vec4(texels, 1.0F / texels, 0.0F, static_cast<float>(border)));
}

} // namespace

glm::vec4 placement_of(const ParallelView& view, const scene::CameraView& camera) {
    const glm::dvec2 texel = (glm::dvec2(view.light_from(camera.position)) - view.min) / view.texel;
    return {glm::vec2(1.0 / view.texel), glm::vec2(texel)};
}

void set_view(
    const gpu::Program& mask,
    const ParallelView& view,
    const scene::CameraView& camera,
    int border) {
    const double per_metre = -1.0 / (view.farthest - view.nearest);
    const double eye = (view.light_from(camera.position).z - view.farthest) * per_metre;
    mask.set("light_from_world", glm::mat3(view.light_from_world));
    mask.set("light_position", glm::vec3(0.0F));
    mask.set("map_depth", glm::vec4(glm::dvec4(per_metre, eye, 0.0, 0.0)));
    set_size(mask, view.size, border);
    mask.set("placement[0]", placement_of(view, camera));
}

void set_view(const gpu::Program& mask, const PyramidView& view, const scene::CameraView& camera) {
    const glm::dvec2 texels = static_cast<double>(view.size) / (view.max - view.min);
    mask.set("light_from_world", glm::mat3(view.light_from_world));
    mask.set("light_position", glm::vec3(view.position - camera.position));
    mask.set("map_depth", glm::vec4(static_cast<float>(view.near), 0.0F, 0.0F, 0.0F));
    set_size(mask, view.size, 0);
    mask.set("placement[0]", glm::vec4(glm::dvec4(texels, -view.min * texels)));
}

} // namespace shadows
