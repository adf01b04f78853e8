#include "engine/scene/scene_builder.hpp"

#include "engine/core/check.hpp"
#include "engine/core/text.hpp"
#include "engine/scene/framing.hpp"
#include "engine/scene/gltf.hpp"
#include "engine/scene/primitives.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace scene {

namespace {

/// A shape's mesh for size 1 where it can be stretched, and what stretches it.
struct ShapeMesh {
    Mesh mesh;
    glm::vec3 stretch = {1.0F, 1.0F, 1.0F};
};

/// Round shapes are made round across x and stretched to their z (and a sphere to its y).
ShapeMesh make_shape(const std::string& shape, const glm::vec3& size) {
    const float radius = size.x / 2.0F;
    const glm::vec3 stretch(1.0F, 1.0F, size.z / size.x);
    if (shape == "box") return {make_box(size)};
    if (shape == "plane") return {make_plane({size.x, size.z})};
    if (shape == "sphere") return {make_sphere(radius), {1.0F, size.y / size.x, stretch.z}};
    if (shape == "cylinder") return {make_cylinder(radius, size.y), stretch};
    if (shape == "cone") return {make_cone(radius, size.y), stretch};
    CHECK(shape == "torus");
    const float tube = size.y / 2.0F;
    return {make_torus(radius - tube, tube), stretch};
}

class Builder {
public:
    Builder(std::filesystem::path folder, World& world)
        : folder_(std::move(folder)),
          world_(world) {}

    engine::Result<void> add(const ModelDescription& model) {
        if (!model.shape.empty()) {
            follow(model, add_shape(model));
            return {};
        }
        const auto assets = file_assets(model);
        if (!assets) return assets.error();
        const ecs::Entity root = instantiate(world_, **assets, model.name);
        world_.registry.patch<Transform>(
            root, [&](Transform& transform) { transform = model.transform; });
        roles_.emplace(root, role_of(model));
        follow(model, root);
        return play(model, **assets, root);
    }

    /// Before the models that go along them.
    void add(const PathDescription& path) {
        paths_.emplace(path.name, static_cast<std::uint32_t>(world_.assets.paths.size()));
        world_.assets.paths.push_back({path.name, path.points, path.closed});
    }

    template <class Description, class Component>
    void add(const Description& description, const Component& component) {
        const ecs::Entity entity = make(description.name, description.transform);
        world_.registry.add(entity, component);
    }

    /// Gives every mesh below a model the model's part in shadows.
    void spread_roles() {
        std::vector<std::pair<ecs::Entity, ShadowRole>> changes;
        world_.registry.each<ShadowRole>([&](ecs::Entity entity, const ShadowRole& /*old*/) {
            const auto found = roles_.find(root_of(entity));
            if (found != roles_.end()) changes.emplace_back(entity, found->second);
        });
        for (const auto& [entity, role] : changes)
            world_.registry.patch<ShadowRole>(
                entity, [&, wanted = role](ShadowRole& now) { now = wanted; });
    }

    [[nodiscard]] Warnings& warnings() { return warnings_; }

private:
    using ShapeKey = std::pair<std::string, std::array<float, 7>>; ///< shape, size, colour

    static ShadowRole role_of(const ModelDescription& model) {
        return {model.casts, model.receives, model.hero};
    }

    ecs::Entity make(const std::string& name, const Transform& transform) {
        const ecs::Entity entity = world_.registry.create();
        world_.registry.add(entity, Name{name});
        world_.registry.add(entity, transform);
        world_.registry.add(entity, WorldTransform{});
        return entity;
    }

    ecs::Entity root_of(ecs::Entity entity) const {
        while (const Parent* parent = world_.registry.try_get<Parent>(entity))
            entity = parent->entity;
        return entity;
    }

    void follow(const ModelDescription& model, ecs::Entity entity) {
        if (!model.path) return;
        const auto found = paths_.find(*model.path);
        CHECK(found != paths_.end()); // whoever read the level has checked the name
        const Path& path = world_.assets.paths[found->second];
        const double travelled = static_cast<double>(model.path_start) * period(path);
        world_.registry.add(entity, PathFollower{found->second, travelled, model.path_speed});
    }

    ecs::Entity add_shape(const ModelDescription& model) {
        const glm::vec4 color = model.color.value_or(glm::vec4(0.8F, 0.8F, 0.8F, 1.0F));
        const glm::vec3& size = model.size;
        const ShapeKey key{
            model.shape, {size.x, size.y, size.z, color.x, color.y, color.z, color.w}};
        auto found = shapes_.find(key);
        if (found == shapes_.end()) {
            ShapeMesh shape = make_shape(model.shape, size);
            Model assets;
            shape.mesh.name = model.shape;
            assets.meshes.push_back(std::move(shape.mesh));
            assets.materials.emplace_back().base_color = color;
            const std::uint32_t mesh = add_assets(world_.assets, std::move(assets)).first_mesh;
            found = shapes_.emplace(key, std::pair(mesh, shape.stretch)).first;
        }
        Transform transform = model.transform;
        transform.scale *= found->second.second;
        const ecs::Entity entity = make(model.name, transform);
        world_.registry.add(entity, MeshInstance{found->second.first});
        world_.registry.add(entity, role_of(model));
        return entity;
    }

    /// The file's assets, read on first use.
    engine::Result<const ModelAssets*> file_assets(const ModelDescription& model) {
        auto found = files_.find(model.file);
        if (found == files_.end()) {
            auto loaded = load_gltf(folder_ / model.file);
            if (!loaded) {
                return engine::Error{
                    fmt::format("model \"{}\": {}", model.name, engine::to_string(loaded.error())),
                    model.place};
            }
            for (const std::string& warning : loaded->warnings)
                warnings_.push_back(fmt::format("{}: {}", model.file, warning));
            found = files_.emplace(model.file, add_assets(world_.assets, std::move(*loaded))).first;
        }
        return &found->second;
    }

    engine::Result<void>
    play(const ModelDescription& model, const ModelAssets& assets, ecs::Entity root) {
        std::uint32_t clip = 0;
        if (model.animation) {
            std::vector<std::string_view> names;
            for (std::uint32_t i = 0; i < assets.clip_count; ++i)
                names.emplace_back(world_.assets.clips[assets.first_clip + i].name);
            while (clip < names.size() && names[clip] != *model.animation)
                ++clip;
            if (clip == names.size()) {
                return engine::Error{
                    fmt::format(
                        "model \"{}\": animation is \"{}\", which is no clip of {}{}",
                        model.name,
                        *model.animation,
                        model.file,
                        engine::did_you_mean(*model.animation, names)),
                    model.place};
            }
        }
        if (assets.clip_count == 0) return {};
        world_.registry.patch<AnimationPlayer>(root, [&](AnimationPlayer& player) {
            player.clip = clip;
            player.speed = model.animation_speed;
            player.time = model.animation_start;
        });
        return {};
    }

    std::filesystem::path folder_;
    World& world_;
    std::map<std::string, ModelAssets> files_;                       ///< by name as written
    std::map<ShapeKey, std::pair<std::uint32_t, glm::vec3>> shapes_; ///< mesh and stretch
    std::map<std::string, std::uint32_t> paths_;                     ///< index by name
    std::unordered_map<ecs::Entity, ShadowRole> roles_;              ///< of model roots
    Warnings warnings_;
};

/// Makes the proxies of every mesh that a hero shows.
void simplify_heroes(World& world) {
    std::set<std::uint32_t> meshes;
    world.registry.each<MeshInstance, ShadowRole>(
        [&](ecs::Entity, const MeshInstance& instance, const ShadowRole& role) {
            if (role.hero) meshes.insert(instance.mesh);
        });
    for (const std::uint32_t index : meshes) {
        Mesh& mesh = world.assets.meshes[index];
        mesh.proxies = make_proxies(mesh);
    }
}

} // namespace

engine::Result<Warnings> build_world(
    const SceneDescription& description, const std::filesystem::path& folder, World& world) {
    world.ambient = description.ambient;
    if (description.exposure) world.exposure = *description.exposure;
    Builder builder(folder, world);
    for (const PathDescription& path : description.paths)
        builder.add(path);
    for (const ModelDescription& model : description.models)
        if (const auto added = builder.add(model); !added) return added.error();
    for (const LightDescription& light : description.lights)
        builder.add(light, light.light);
    for (const CameraDescription& camera : description.cameras)
        builder.add(camera, camera.camera);
    builder.spread_roles();
    simplify_heroes(world);
    update(world, 0.0F);
    return std::move(builder.warnings());
}

engine::Result<Warnings> build_world_from_gltf(const std::filesystem::path& file, World& world) {
    auto model = load_gltf(file);
    if (!model) return model.error();
    Warnings warnings = model->warnings;
    instantiate(world, add_assets(world.assets, std::move(*model)), "");

    if (world.registry.count<Light>() == 0) {
        LightDescription sun;
        sun.name = "sun";
        sun.light.intensity = 60000.0F;
        sun.light.angular_radius = glm::radians(0.53F / 2.0F);
        sun.transform.rotation = rotation_along({-0.4, -1.0, -0.3});
        Builder({}, world).add(sun, sun.light);
        warnings.push_back(fmt::format("{} has no light; a sun was added", file.generic_string()));
    }
    if (world.registry.count<Camera>() == 0)
        warnings.push_back(fmt::format(
            "{} has no camera; one that sees everything is used", file.generic_string()));
    update(world, 0.0F);
    return warnings;
}

} // namespace scene
