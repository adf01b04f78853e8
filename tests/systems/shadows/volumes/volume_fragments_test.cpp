// Predicted fragments against those of the volumes that are drawn.

#include "systems/shadows/snapshot.hpp"
#include "systems/shadows/volumes/volume_prediction.hpp"
#include "tests/support/worlds.hpp"
#include "tests/systems/shadows/volumes/volume_fragments.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

namespace shadows {
namespace {

using test_support::at;

struct Fragments {
    double predicted = 0.0; ///< stencil fragments, without what lowers the mask
    double counted = 0.0;
};

/// Of one caster on a floor 20 m wide.
Fragments compare(scene::Mesh mesh, const scene::PlacedLight& light) {
    test_support::WorldBuilder builder = test_support::floor_of(20.0F);
    builder.add("caster", std::move(mesh), at({0.0, 1.6, 0.0}));
    scene::update(builder.world, 0.0F);
    const ShadowScene scene = take_snapshot(
        builder.world,
        scene::ReceiverTable(builder.world),
        test_support::usual_camera(512),
        std::vector{light});
    std::vector<CasterGroup> groups;
    Plan plan;
    for (std::uint32_t i = 0; i < scene.casters.size(); ++i)
        if (scene.casters[i].name == "caster")
            groups.push_back({{i}, scene.casters[i].bounds, 0.0, false, 0});
    const scene::ShadowWish wish;
    const ReceiverView* floor = nullptr;
    for (const ReceiverView& receiver : scene.receivers)
        if (receiver.name.starts_with("floor")) floor = &receiver;
    plan.receiver = floor->id;
    plan.entries.push_back({"volume", {0}, {}});
    const std::vector<const Plan*> plans{&plan};
    const Remedies remedies;
    const std::function<const trace::TraceScene&()> truth;
    VolumeCasters casters;
    casters.update({builder.world, scene, 0, groups, plans, 100, true, wish, remedies, truth});

    Fragments fragments;
    const auto predicted =
        predict_volume({scene, scene.lights[0], *floor, wish, 1.0}, groups.front());
    fragments.predicted = predicted->cost.stencil_fragments - predicted->cost.taps;
    for (const VolumeCaster& caster : casters.all())
        fragments.counted += fragments_of(caster, scene.camera, false);
    return fragments;
}

TEST(VolumeFragments, OfAConvexCasterAreTwiceItsSweptOutlineAndWithinItsScissor) {
    const Fragments ball = compare(scene::make_sphere(0.8F, 48), test_support::sun_at(45.0, 20.0));

    EXPECT_LE(ball.counted, ball.predicted);
    EXPECT_GE(ball.counted, 0.25 * ball.predicted);
}

TEST(VolumeFragments, ArePredictedWithinAFactorOfThree) {
    const std::vector<scene::PlacedLight> lights = {
        test_support::sun_at(45.0, 20.0),
        test_support::lamp_light("lamp", {1.0, 5.0, 2.0}, 100.0F, 1000.0F)};
    const std::map<std::string, scene::Mesh> meshes = {
        {"box", scene::make_box(glm::vec3(1.0F))},
        {"ball", scene::make_sphere(0.8F, 48)},
        {"ring", scene::make_torus(1.0F, 0.35F)},
        {"dense ring", scene::make_torus(1.0F, 0.35F, 192, 80)}};
    for (const scene::PlacedLight& light : lights)
        for (const auto& [name, mesh] : meshes) {
            const Fragments seen = compare(mesh, light);
            SCOPED_TRACE(fmt::format(
                "{} under a {}: {:.0f} predicted, {:.0f} counted",
                name,
                light.name,
                seen.predicted,
                seen.counted));

            EXPECT_GT(seen.predicted, seen.counted / 3.0);
            EXPECT_LT(seen.predicted, seen.counted * 3.0);
        }
}

} // namespace
} // namespace shadows
