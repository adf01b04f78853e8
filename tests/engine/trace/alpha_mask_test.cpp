#include "engine/trace/alpha_mask.hpp"
#include "engine/trace/visibility.hpp"
#include "tests/engine/trace/small_world.hpp"

#include <gtest/gtest.h>

namespace trace {
namespace {

/// Two texels: the left one clear, the right one opaque.
scene::Texture half_clear() {
    scene::Texture texture;
    texture.image = engine::Image(2, 1, 4);
    texture.image.at(1, 0)[3] = 255;
    return texture;
}

scene::Material cut_out() {
    scene::Material material;
    material.alpha_masked = true;
    material.texture = 0;
    return material;
}

TEST(AlphaMask, IsBilinearBetweenTexelCentres) {
    const std::vector<scene::Texture> textures = {half_clear()};
    const AlphaMask mask(cut_out(), textures);

    EXPECT_TRUE(mask.hole_at({0.25, 0.5}));
    EXPECT_TRUE(mask.hole_at({0.499, 0.5}));
    EXPECT_FALSE(mask.hole_at({0.501, 0.5}));
    EXPECT_FALSE(mask.hole_at({0.75, 0.5}));
}

TEST(AlphaMask, RepeatsBlendAcrossTheSeamAndClampsDoNot) {
    std::vector<scene::Texture> textures = {half_clear()};
    scene::Material material = cut_out();
    material.alpha_cutoff = 0.25F;

    EXPECT_FALSE(AlphaMask(material, textures).hole_at({0.05, 0.5}));
    EXPECT_FALSE(AlphaMask(material, textures).hole_at({-5.2, 3.7}));
    textures[0].wrap_u = scene::Wrap::clamp;
    EXPECT_TRUE(AlphaMask(material, textures).hole_at({0.05, 0.5}));
    EXPECT_TRUE(AlphaMask(material, textures).hole_at({-9.0, 0.5}));
    EXPECT_FALSE(AlphaMask(material, textures).hole_at({9.0, 0.5}));
}

TEST(AlphaMask, MirrorsTurnEverySecondTileRound) {
    std::vector<scene::Texture> textures = {half_clear()};
    textures[0].wrap_u = scene::Wrap::mirror;
    const AlphaMask mask(cut_out(), textures);

    EXPECT_TRUE(mask.hole_at({0.25, 0.5}));
    EXPECT_FALSE(mask.hole_at({1.25, 0.5}));
    EXPECT_TRUE(mask.hole_at({1.75, 0.5}));
    EXPECT_TRUE(mask.hole_at({-0.25, 0.5}));
}

TEST(AlphaMask, NearestTakesTheTexelItLiesIn) {
    std::vector<scene::Texture> textures = {half_clear()};
    textures[0].nearest = true;
    scene::Material material = cut_out();
    material.alpha_cutoff = 0.01F;
    const AlphaMask mask(material, textures);

    EXPECT_TRUE(mask.hole_at({0.49, 0.5}));
    EXPECT_FALSE(mask.hole_at({0.51, 0.5}));
}

TEST(AlphaMask, WithoutTextureTheFactorDecides) {
    scene::Material material = cut_out();
    material.texture = scene::kNoTexture;
    material.base_color.a = 0.49F;
    EXPECT_TRUE(AlphaMask(material, {}).hole_at({0, 0}));
    material.base_color.a = 0.5F;
    EXPECT_FALSE(AlphaMask(material, {}).hole_at({0, 0}));
}

TEST(AlphaMask, HolesLetCameraAndShadowRaysThroughAlike) {
    SmallWorld small;
    small.world.assets.textures.push_back(half_clear());
    small.world.assets.materials.push_back(cut_out());
    const ecs::Entity floor = small.add(scene::make_plane({10, 10}));
    scene::Mesh card = scene::make_plane({2, 2});
    card.submeshes[0].material = 1;
    const ecs::Entity leaf = small.add(std::move(card), {0, 1, 0});
    const TraceScene scene(small.world);
    const scene::PlacedLight sun = sun_along({0, -1, 0});

    EXPECT_EQ(scene.intersect({-0.5, 5, 0.3}, {0, -1, 0})->entity, floor);
    EXPECT_EQ(scene.intersect({0.5, 5, 0.3}, {0, -1, 0})->entity, leaf);
    EXPECT_EQ(visibility(scene, sun, {-0.5, 0, 0.3}, {0, 1, 0}), 1.0F);
    EXPECT_EQ(visibility(scene, sun, {0.5, 0, 0.3}, {0, 1, 0}), 0.0F);
}

} // namespace
} // namespace trace
