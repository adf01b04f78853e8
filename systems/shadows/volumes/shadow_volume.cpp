#include "systems/shadows/volumes/shadow_volume.hpp"

#include <cstdlib>

namespace shadows {

namespace {

std::uint32_t near_index(std::uint32_t vertex) {
    return 2 * vertex;
}
std::uint32_t far_index(std::uint32_t vertex) {
    return 2 * vertex + 1;
}

/// Above 0 when the light lies before the triangle; of a sun, when its way does.
double side_of(
    std::span<const glm::vec3> positions, const std::uint32_t* corners, const glm::dvec4& light) {
    const glm::dvec3 a(positions[corners[0]]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(positions[corners[1]]) - a, glm::dvec3(positions[corners[2]]) - a);
    return glm::dot(normal, glm::dvec3(light) - a * light.w);
}

} // namespace

void VolumeBuilder::weigh(
    const CasterSurface& surface,
    std::span<const glm::vec3> positions,
    const glm::dvec4& light_mesh,
    bool surrounded) {
    const std::uint32_t count = surface.triangle_count();
    facing_.resize(count);
    weights_.resize(count + 1);
    weights_[count] = 0;
    cap_count_ = facing_cap_count_ = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        const bool faces =
            side_of(positions, &surface.corners[std::size_t{3} * t], light_mesh) > 0.0;
        const bool lit = faces != (surface.turned[t] != 0);
        const std::int8_t dark = surrounded ? std::int8_t{-1} : surface.dark_weight[t];
        const std::int8_t weight = lit ? std::int8_t{1} : dark;
        facing_[t] = faces ? 1 : 0;
        weights_[t] = weight;
        cap_count_ += weight != 0 ? 1 : 0;
        facing_cap_count_ += weight != 0 && faces ? 1 : 0;
    }
}

void VolumeBuilder::add_sides(const CasterSurface& surface, bool lamp, ShadowVolume& volume) const {
    for (const CasterSurface::Edge& edge : surface.edges) {
        const int weight = weights_[edge.left] - weights_[edge.right];
        if (weight == 0) continue;
        ++volume.outline_edges;
        // The same diagonal whichever way the side faces, so that opposite sides cancel exactly.
        const std::uint32_t a = near_index(edge.from);
        const std::uint32_t b = near_index(edge.to);
        const std::uint32_t far_a = far_index(edge.from);
        const std::uint32_t far_b = far_index(edge.to);
        for (int i = 0; i < std::abs(weight); ++i) {
            if (weight > 0)
                volume.indices.insert(volume.indices.end(), {b, a, far_a});
            else
                volume.indices.insert(volume.indices.end(), {a, b, far_a});
            if (!lamp) continue; // a sun's far corners are one point
            if (weight > 0)
                volume.indices.insert(volume.indices.end(), {b, far_a, far_b});
            else
                volume.indices.insert(volume.indices.end(), {far_a, b, far_b});
        }
    }
}

void VolumeBuilder::add_far_caps(const CasterSurface& surface, ShadowVolume& volume) const {
    volume.indices.resize(3 * cap_count_);
    std::uint32_t* cap = volume.indices.data();
    for (std::uint32_t t = 0; t < surface.triangle_count(); ++t) {
        if (weights_[t] == 0) continue;
        const std::uint32_t* corners = &surface.corners[std::size_t{3} * t];
        const bool faces = facing_[t] != 0;
        *cap++ = far_index(corners[0]);
        *cap++ = far_index(corners[faces ? 2 : 1]);
        *cap++ = far_index(corners[faces ? 1 : 2]);
    }
}

void VolumeBuilder::add_near_caps(const CasterSurface& surface, ShadowVolume& volume) const {
    const std::size_t first = volume.indices.size();
    volume.near_end = static_cast<std::uint32_t>(first + 3 * facing_cap_count_);
    volume.indices.resize(first + 3 * cap_count_);
    std::uint32_t* facing_cap = volume.indices.data() + first;
    std::uint32_t* turned_cap = volume.indices.data() + volume.near_end;
    for (std::uint32_t t = 0; t < surface.triangle_count(); ++t) {
        if (weights_[t] == 0) continue;
        std::uint32_t*& cap = facing_[t] != 0 ? facing_cap : turned_cap;
        for (std::size_t k = 0; k < 3; ++k)
            *cap++ = near_index(surface.corners[std::size_t{3} * t + k]);
    }
}

void VolumeBuilder::build(
    const CasterSurface& surface,
    std::span<const glm::vec3> positions,
    const glm::dvec4& light_mesh,
    bool surrounded,
    ShadowVolume& volume) {
    const bool lamp = light_mesh.w != 0.0;
    volume.indices.clear();
    volume.outline_edges = 0;
    weigh(surface, positions, light_mesh, surrounded);
    if (lamp) add_far_caps(surface, volume); // a sun's are one point
    volume.far_end = static_cast<std::uint32_t>(volume.indices.size());
    add_sides(surface, lamp, volume);
    volume.side_end = static_cast<std::uint32_t>(volume.indices.size());
    add_near_caps(surface, volume);
}

} // namespace shadows
