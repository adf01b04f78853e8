// Any bytes as a model: they are refused with a sentence, or become a world whose numbers are all
// sound, at rest and a moment later.

#include "engine/core/check.hpp"
#include "engine/scene/gltf.hpp"
#include "engine/scene/world.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool unit(const glm::vec3& v) {
    return std::abs(glm::length(v) - 1.0F) < 1e-3F;
}

void check_submeshes(const scene::Mesh& mesh, std::size_t material_count) {
    for (const scene::Submesh& submesh : mesh.submeshes) {
        CHECK_LE(std::uint64_t{submesh.first_index} + submesh.index_count, mesh.indices.size());
        CHECK_LT(submesh.material, material_count);
        const bool triangles = submesh.topology == scene::Topology::triangles;
        const bool lines = submesh.topology == scene::Topology::lines;
        CHECK_EQ(submesh.index_count % (triangles ? 3U : lines ? 2U : 1U), 0U);
    }
}

void check_mesh(const scene::Mesh& mesh, std::size_t material_count) {
    const std::size_t count = mesh.positions.size();
    CHECK_EQ(mesh.normals.size(), count);
    CHECK(mesh.uvs.empty() || mesh.uvs.size() == count);
    CHECK(mesh.influences.empty() || mesh.influences.size() == count);
    CHECK(mesh.patch_ids.empty() || mesh.patch_ids.size() == count);
    CHECK_EQ(mesh.morph_weights.size(), mesh.morph_targets.size());
    for (const scene::MorphTarget& target : mesh.morph_targets) {
        CHECK_EQ(target.position_deltas.size(), count);
        CHECK(target.normal_deltas.empty() || target.normal_deltas.size() == count);
    }
    for (const std::uint32_t index : mesh.indices)
        CHECK_LT(index, count);
    for (std::size_t i = 0; i < count; ++i) {
        CHECK(finite(mesh.positions[i]));
        CHECK(unit(mesh.normals[i]));
    }
    check_submeshes(mesh, material_count);
}

void check_model(const scene::Model& model) {
    for (const scene::Mesh& mesh : model.meshes)
        check_mesh(mesh, model.materials.size());
    for (const scene::Material& material : model.materials)
        CHECK(material.texture == scene::kNoTexture || material.texture < model.textures.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const scene::Node& node = model.nodes[i];
        CHECK(!node.parent || *node.parent < i);
        CHECK(!node.mesh || *node.mesh < model.meshes.size());
        CHECK(!node.skin || *node.skin < model.skins.size());
        CHECK(!node.camera || *node.camera < model.cameras.size());
        CHECK(!node.light || *node.light < model.lights.size());
    }
}

void check_world(const scene::World& world) {
    world.registry.each<scene::WorldTransform>(
        [](ecs::Entity /*entity*/, const scene::WorldTransform& placed) {
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row)
                    CHECK(std::isfinite(placed.world_from_local[column][row]));
        });
    world.registry.each<scene::PosedMesh>(
        [](ecs::Entity /*entity*/, const scene::PosedMesh& posed) {
            for (std::size_t i = 0; i < posed.positions.size(); ++i) {
                CHECK(finite(posed.positions[i]));
                CHECK(unit(posed.normals[i]));
            }
        });
    const engine::WorldAabb bounds = scene::world_bounds(world);
    CHECK(
        bounds.empty()
        || (std::isfinite(glm::length(bounds.min)) && std::isfinite(glm::length(bounds.max))));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    auto model = scene::load_gltf_bytes(std::span(data, size), "fuzz");
    if (!model) {
        CHECK(!model.error().message.empty());
        return 0;
    }
    check_model(*model);

    scene::World world;
    const scene::ModelAssets assets = scene::add_assets(world.assets, std::move(*model));
    scene::instantiate(world, assets, "fuzz");
    scene::update(world, 0.0F);
    check_world(world);
    scene::update(world, 0.3F);
    check_world(world);
    return 0;
}
