#include "engine/trace/exact_geometry.hpp"

#include "engine/core/check.hpp"

namespace trace {
namespace {

constexpr double kOverlap = 1e-9;

/// The triangles of one submesh.
class SubmeshReader {
public:
    SubmeshReader(
        const scene::World& world,
        const scene::Mesh& mesh,
        const scene::Submesh& submesh,
        ExactGeometry& out)
        : mesh_(mesh),
          out_(out) {
        const scene::Material& material = world.assets.materials[submesh.material];
        double_sided_ = material.double_sided;
        masked_ = material.alpha_masked;
        if (masked_) out.masks.emplace_back(material, world.assets.textures);
    }

    void add(std::uint32_t first_index) {
        ExactTriangle triangle;
        for (std::uint32_t k = 0; k < 3; ++k)
            triangle.corners[k] = mesh_.indices[first_index + k];
        const glm::dvec3& a = out_.positions[triangle.corners[0]];
        const glm::dvec3& b = out_.positions[triangle.corners[1]];
        const glm::dvec3& c = out_.positions[triangle.corners[2]];
        if (!(glm::length(glm::cross(b - a, c - a)) > 0.0)) return;
        triangle.first_index = first_index;
        triangle.double_sided = double_sided_;
        if (!mesh_.patch_ids.empty()) triangle.patch_id = mesh_.patch_ids[triangle.corners[0]];
        if (masked_) {
            triangle.mask = static_cast<std::uint16_t>(out_.masks.size() - 1);
            triangle.mask_corner = static_cast<std::uint32_t>(out_.uvs.size());
            for (const std::uint32_t corner : triangle.corners)
                out_.uvs.push_back(mesh_.uvs.empty() ? glm::vec2(0.0F) : mesh_.uvs[corner]);
        }
        out_.triangles.push_back(triangle);
        for (const std::uint32_t corner : triangle.corners)
            out_.bounds.grow(out_.positions[corner]);
    }

private:
    const scene::Mesh& mesh_;
    ExactGeometry& out_;
    bool double_sided_ = false;
    bool masked_ = false;
};

} // namespace

engine::Box<glm::dvec3> ExactGeometry::triangle_bounds(std::uint32_t triangle) const {
    engine::Box<glm::dvec3> box;
    for (const std::uint32_t corner : triangles[triangle].corners)
        box.grow(positions[corner]);
    return box;
}

glm::dvec3 ExactGeometry::normal(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles[triangle].corners;
    const glm::dvec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
    return (mirrored ? -1.0 : 1.0) / glm::length(normal) * normal;
}

std::optional<Crossing> ExactGeometry::cross(
    std::uint32_t triangle, const glm::dvec3& origin, const glm::dvec3& direction) const {
    const auto& [a, b, c] = triangles[triangle].corners;
    const glm::dvec3 edge_1 = positions[b] - positions[a];
    const glm::dvec3 edge_2 = positions[c] - positions[a];
    const glm::dvec3 p = glm::cross(direction, edge_2);
    const double determinant = glm::dot(edge_1, p);
    if (determinant == 0.0) return std::nullopt; // parallel: neighbours catch the ray
    const glm::dvec3 from_a = origin - positions[a];
    const double u = glm::dot(from_a, p) / determinant;
    if (!(u >= -kOverlap && u <= 1.0 + kOverlap)) return std::nullopt;
    const glm::dvec3 q = glm::cross(from_a, edge_1);
    const double v = glm::dot(direction, q) / determinant;
    if (!(v >= -kOverlap && u + v <= 1.0 + kOverlap)) return std::nullopt;
    return Crossing{glm::dot(edge_2, q) / determinant, u, v};
}

bool ExactGeometry::hole_at(std::uint32_t triangle, const Crossing& crossing) const {
    const ExactTriangle& at = triangles[triangle];
    if (at.mask_corner == kNoMask) return false;
    const glm::dvec2 uv = (1.0 - crossing.u - crossing.v) * glm::dvec2(uvs[at.mask_corner])
                          + crossing.u * glm::dvec2(uvs[at.mask_corner + 1])
                          + crossing.v * glm::dvec2(uvs[at.mask_corner + 2]);
    return masks[at.mask].hole_at(uv);
}

ExactGeometry
exact_geometry(const scene::World& world, ecs::Entity entity, const glm::dvec3& origin) {
    const scene::Mesh& mesh =
        world.assets.meshes[world.registry.get<scene::MeshInstance>(entity).mesh];
    const auto* posed = world.registry.try_get<scene::PosedMesh>(entity);
    const std::vector<glm::vec3>& local = posed != nullptr ? posed->positions : mesh.positions;
    CHECK_EQ(local.size(), mesh.positions.size());

    const auto& transform = world.registry.get<scene::WorldTransform>(entity);
    glm::dmat4 relative_from_local = transform.world_from_local;
    relative_from_local[3] -= glm::dvec4(origin, 0.0);

    ExactGeometry out;
    out.entity = entity;
    out.mirrored = transform.mirrored();
    out.positions.reserve(local.size());
    for (const glm::vec3& position : local)
        out.positions.emplace_back(relative_from_local * glm::dvec4(glm::dvec3(position), 1.0));
    for (const scene::Submesh& submesh : mesh.submeshes) {
        if (submesh.topology != scene::Topology::triangles) continue;
        SubmeshReader reader(world, mesh, submesh, out);
        for (std::uint32_t i = 0; i < submesh.index_count; i += 3)
            reader.add(submesh.first_index + i);
    }
    return out;
}

} // namespace trace
