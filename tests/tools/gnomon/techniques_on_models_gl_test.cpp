// Every technique on every model that is at hand: what is in its domain is drawn and right wherever
// its resolution is no excuse, what is not is refused with a reason.

#include "engine/scene/framing.hpp"
#include "engine/scene/primitives.hpp"
#include "engine/scene/views.hpp"
#include "systems/shadows/technique_registry.hpp"
#include "tests/support/assets.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tools/gnomon/comparing.hpp"
#include "tools/gnomon/row_pictures.hpp"
#include "tools/gnomon/serving.hpp"
#include "tools/gnomon/text_files.hpp"
#include "tools/measure/figures.hpp"

namespace gnomon {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;

/// Models that can be loaded, by their place under the folder.
std::vector<std::string> models() {
    std::vector<std::string> names;
    const std::filesystem::path folder = test_support::assets_folder();
    if (folder.empty()) return names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const auto kind = entry.path().extension();
        if ((kind == ".glb" || kind == ".gltf") && entry.path().parent_path().stem() != "broken")
            names.push_back(std::filesystem::relative(entry.path(), folder).string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

constexpr const char* kLamp = "lamp above";
constexpr const char* kSpot = "spot above";

/// A light over the model's right front corner that reaches everything.
void add_light(
    scene::World& world, const engine::WorldAabb& bounds, scene::LightKind kind, const char* name) {
    const double size = glm::length(bounds.extent());
    scene::Transform place;
    place.position = bounds.centre() + glm::dvec3(0.35, 0.9, 0.5) * size;
    place.rotation = scene::rotation_along(bounds.centre() - place.position);
    scene::Light light;
    light.kind = kind;
    light.intensity = 100.0F;
    light.range = static_cast<float>(10.0 * size);
    light.outer_angle = glm::radians(45.0F);
    light.inner_angle = light.outer_angle;
    const ecs::Entity entity = world.registry.create();
    world.registry.add(entity, scene::Name{name});
    world.registry.add(entity, place);
    world.registry.add(entity, scene::WorldTransform{});
    world.registry.add(entity, light);
}

/// The model, stood on a floor that reaches as far as its shadows at noon, with a lamp and a spot
/// besides its own lights.
engine::Result<Level> on_a_floor(const std::string& model) {
    auto level = load_level(test_support::assets_folder() / model);
    if (!level) return level;
    scene::World& world = level->world;
    const engine::WorldAabb bounds = scene::world_bounds(world);
    const double side = 2.0 * glm::length(bounds.extent());
    world.assets.meshes.push_back(scene::make_plane(glm::vec2(static_cast<float>(side))));
    world.assets.materials.emplace_back();
    auto& floor = world.assets.meshes.back();
    for (scene::Submesh& part : floor.submeshes)
        part.material = static_cast<std::uint32_t>(world.assets.materials.size() - 1);
    const ecs::Entity entity = world.registry.create();
    scene::Transform place;
    place.position = {bounds.centre().x, bounds.min.y - 1e-4 * side, bounds.centre().z};
    world.registry.add(entity, scene::Name{"floor below"});
    world.registry.add(entity, place);
    world.registry.add(entity, scene::WorldTransform{});
    world.registry.add(
        entity, scene::MeshInstance{static_cast<std::uint32_t>(world.assets.meshes.size() - 1)});
    world.registry.add(entity, scene::ShadowRole{});
    add_light(world, bounds, scene::LightKind::point, kLamp);
    add_light(world, bounds, scene::LightKind::spot, kSpot);
    scene::update(world, 0.0F);
    return level;
}

/// What one technique did for one light of a model.
struct Result {
    std::size_t asked = 0;         ///< pairs
    std::size_t served = 0;        ///< of those
    std::set<std::string> reasons; ///< of the others
    measure::Figures figures;      ///< of the pixels that are served
};

/// Leaves out what the technique refused.
void forget_unserved(
    const shadows::ShadowSystem& shadows,
    std::size_t light_index,
    const DrawnSurfaces& drawn,
    measure::Comparison& comparison,
    Result& result) {
    const std::uint32_t light = shadows.scene().lights[light_index].id;
    std::set<std::uint32_t> refused;
    for (const shadows::Plan& plan : shadows.plan().plans) {
        if (plan.light != light) continue;
        ++result.asked;
        if (!plan.entries.empty()) {
            ++result.served;
            continue;
        }
        refused.insert(plan.receiver);
        for (const shadows::Rejection& rejection : plan.rejected)
            if (rejection.reason.starts_with("outside its domain"))
                result.reasons.insert(rejection.reason);
    }
    for (std::size_t pixel = 0; pixel < comparison.kind.size(); ++pixel)
        if (refused.contains(drawn.receiver[pixel]))
            comparison.kind[pixel] = measure::PixelKind::facing_away;
}

/// Wrong pixels beyond the technique's resolution: one, where a shadow thinner than a pixel has
/// edges that the truth's search for them misses. Of a map two in a thousand: it does not know what
/// hovers within a texel of what it darkens, like a torch's cage before its bowl (6 of 3360).
double allowed(const std::string& technique, const measure::Figures& figures) {
    return technique.ends_with("_map") ? std::max(1.0, 0.002 * figures.valid_px) : 1.0;
}

class TechniquesOnModels : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        if (!Studio::open(kWidth, kHeight)) GTEST_SKIP() << "no OpenGL here";
    }

    static Result try_one(
        Level& level,
        const scene::CameraView& camera,
        std::size_t light,
        const trace::TraceScene& tracer,
        const truth::TruthImage& truth) {
        Result result;
        const auto opened = Studio::open(kWidth, kHeight);
        Studio& studio = **opened;
        const auto done = studio.draw(level, camera);
        EXPECT_TRUE(done) << (done ? "" : engine::to_string(done.error()));
        const DrawnSurfaces drawn = drawn_surfaces(studio, camera);
        const auto mask = studio.mask(light);
        EXPECT_TRUE(mask);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        measure::Comparison comparison =
            make_comparison(*mask, truth, drawn, camera, studio.lights()[light]);
        comparison.resolution_band_px =
            Serving(studio.shadows(), light).bands_px(drawn, truth, camera);
        forget_unserved(studio.shadows(), light, drawn, comparison, result);
        find_hidden_edges(tracer, camera, studio.lights()[light], comparison);
        result.figures = measure::compare(comparison);
        keep_picture(
            level.name + "_" + *level.shadows.lights[studio.lights()[light].name].technique,
            comparison);
        return result;
    }

    /// In the folder of GNOMON_ATLAS_PICTURES, where that is set.
    static void keep_picture(const std::string& name, const measure::Comparison& comparison) {
        const char* folder = std::getenv("GNOMON_ATLAS_PICTURES");
        if (folder == nullptr) return;
        EXPECT_TRUE(engine::write_png(
            std::filesystem::path(folder) / (file_word(name) + ".png"), error_image(comparison)));
    }
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TechniquesOnModels);

TEST_P(TechniquesOnModels, AreRightOrRefuseWithAReason) {
    auto level = on_a_floor(GetParam());
    ASSERT_TRUE(level) << engine::to_string(level.error());
    const auto camera = choose_camera(*level, "", kWidth, kHeight);
    ASSERT_TRUE(camera);
    const trace::TraceScene tracer(level->world);
    const auto lights = scene::placed_lights(level->world);
    const std::string sun = std::find_if(lights.begin(), lights.end(), [](const auto& light) {
                                return light.name != kLamp && light.name != kSpot;
                            })->name;
    std::map<std::string, truth::TruthImage> truths;
    level->shadows.scene.technique = "none";

    for (const auto& technique : shadows::all_techniques()) {
        const std::string name(technique->traits().name);
        if (name == "none") continue;
        SCOPED_TRACE(name);
        const std::string by = name == "spot_map" ? kSpot : name == "cube_map" ? kLamp : sun;
        const auto index = static_cast<std::size_t>(
            std::find_if(
                lights.begin(), lights.end(), [&](const auto& light) { return light.name == by; })
            - lights.begin());
        if (!truths.contains(by))
            truths.emplace(by, truth::true_visibility(tracer, *camera, lights[index]));
        level->shadows.lights = {{by, {}}};
        level->shadows.lights[by].technique = name;
        // Boxes in the place of casters are right within a budget only.
        if (name == "planar") level->shadows.lights[by].way = "geometry";
        const Result result = try_one(*level, *camera, index, tracer, truths.at(by));

        const auto px = [](const measure::Figure& figure) {
            return figure.known() ? figure.value() : -1.0;
        };
        const double dark = px(result.figures.far_false_shadow_px);
        const double lit = px(result.figures.far_light_leak_px);
        fmt::print(
            "{:<48} {:<15} pairs {:>3}, far: false shadow {:>4}, light leak {:>4}, valid {:>6}, "
            "{}\n",
            GetParam(),
            name,
            result.served,
            dark,
            lit,
            result.figures.valid_px,
            fmt::join(result.reasons, "; "));
        EXPECT_TRUE(result.served == result.asked || !result.reasons.empty())
            << "neither drawn nor refused";
        if (name == "blob") continue; // an ellipse in the place of an outline
        const double allowed_px = allowed(name, result.figures);
        EXPECT_LE(dark, allowed_px);
        EXPECT_LE(lit, allowed_px);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Files,
    TechniquesOnModels,
    testing::ValuesIn(models()),
    [](const testing::TestParamInfo<std::string>& one) {
        std::string name;
        for (const char letter : one.param)
            if (std::isalnum(static_cast<unsigned char>(letter)) != 0) name += letter;
        return name;
    });

} // namespace
} // namespace gnomon
