#include "engine/gpu/pass.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/render/renderer.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

using test_support::at;
using test_support::lamp_light;
using test_support::sun_light;
using test_support::WorldBuilder;

constexpr int kWidth = 160;
constexpr int kHeight = 120;

class RendererTest : public test_support::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        color_ = gpu::Texture(
            "picture", {.format = gpu::Format::rgba8, .width = kWidth, .height = kHeight});
        target_ = *gpu::Framebuffer::make("picture", {.colors = {{&color_}}});
        renderer_ = std::make_unique<Renderer>();
    }
    void TearDown() override {
        renderer_.reset();
        target_ = {};
        color_ = {};
        GlTest::TearDown();
    }

    engine::Image draw(
        scene::World& world,
        const scene::CameraView& camera,
        const std::vector<scene::PlacedLight>& lights,
        LightVisibility* visibility = nullptr,
        const FrameSettings& settings = {.exposure = 1.0F}) {
        scene::update(world, 0.0F);
        const auto drawn = renderer_->draw(world, camera, lights, visibility, target_, settings);
        EXPECT_TRUE(drawn) << (drawn ? "" : engine::to_string(drawn.error()));
        return gpu::read_image(color_);
    }

    /// Receiver id at the middle of the picture.
    std::uint32_t middle_id() {
        return gpu::read_uint_pairs(renderer_->gbuffer().surface()).at(kWidth / 2, kHeight / 2).x
               & 0xFFFFFU;
    }

    gpu::Texture color_;
    gpu::Framebuffer target_;
    std::unique_ptr<Renderer> renderer_;
};

scene::CameraView camera_at(const glm::dvec3& position) {
    scene::CameraView camera;
    camera.position = position;
    camera.width = kWidth;
    camera.height = kHeight;
    return camera;
}

void add_still_life(WorldBuilder& builder) {
    builder.add("floor", scene::make_box({20.0F, 0.2F, 20.0F}), at({0, -1.1, -6}));
    builder.add("box", scene::make_box({1.0F, 1.0F, 1.0F}), at({-1.5, -0.5, -5}));
    builder.add("ball", scene::make_sphere(0.7F), at({1.2, -0.3, -6}));
}

std::size_t differing_bytes(const engine::Image& a, const engine::Image& b, int tolerance = 0) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
        if (std::abs(a.bytes[i] - b.bytes[i]) > tolerance) ++count;
    return count;
}

TEST_F(RendererTest, AStillSceneGivesTheSameBitsAgain) {
    WorldBuilder builder;
    add_still_life(builder);

    const auto first = draw(builder.world, camera_at({0, 0.5, 0}), {sun_light()});
    const auto second = draw(builder.world, camera_at({0, 0.5, 0}), {sun_light()});

    EXPECT_EQ(first.bytes, second.bytes);
}

TEST_F(RendererTest, ALevelFarFromTheOriginLooksTheSame) {
    const glm::dvec3 far(1e5, 0.0, 1e5);
    WorldBuilder near_one;
    add_still_life(near_one);
    WorldBuilder far_one(far);
    add_still_life(far_one);

    const auto near_picture = draw(near_one.world, camera_at({0, 0.5, 0}), {sun_light()});
    renderer_ = std::make_unique<Renderer>(); // a renderer follows one world
    const auto far_picture =
        draw(far_one.world, camera_at(far + glm::dvec3(0, 0.5, 0)), {sun_light()});

    EXPECT_LE(differing_bytes(near_picture, far_picture, 1), near_picture.bytes.size() / 2000);
}

TEST_F(RendererTest, WhiteFacingTheSunShowsTheExposedLight) {
    WorldBuilder builder;
    builder.add("wall", scene::make_box({50.0F, 50.0F, 1.0F}), at({0, 0, -10}));
    scene::PlacedLight light = sun_light(0.5F * std::numbers::pi_v<float>);
    light.direction = {0.0F, 0.0F, -1.0F};
    builder.world.ambient = glm::vec3(0.1F);

    const auto picture = draw(builder.world, camera_at({}), {light});

    const double shown = 0.5 + 0.1 - 0.004; // then the film curve of include/tone_map.glsl
    const double expected = shown * (6.2 * shown + 0.5) / (shown * (6.2 * shown + 1.7) + 0.06);
    EXPECT_NEAR(picture.at(kWidth / 2, kHeight / 2)[0], expected * 255.0, 1.5);
}

TEST_F(RendererTest, LampsAgreeWithTheirCpuTwin) {
    WorldBuilder builder;
    builder.add("wall", scene::make_box({50.0F, 50.0F, 1.0F}), at({0, 0, -10}));
    builder.world.ambient = glm::vec3(0.0F);
    for (const bool spot : {false, true}) {
        SCOPED_TRACE(spot);
        scene::PlacedLight lamp = lamp_light("lamp", {0.7, 0.3, -7}, 9.0F, 5.0F);
        if (spot) lamp.light.kind = scene::LightKind::spot;
        lamp.direction = {0.0F, 0.0F, -1.0F};
        lamp.light.inner_angle = 0.1F;

        const auto picture = draw(builder.world, camera_at({}), {lamp});

        const glm::vec3 to_light(0.7F, 0.3F, 2.5F);
        const float cosine = glm::normalize(to_light).z;
        const double light =
            static_cast<double>(
                scene::illuminance_at(lamp, to_light) * cosine * std::numbers::inv_pi_v<float>)
            - 0.004;
        const double expected = light * (6.2 * light + 0.5) / (light * (6.2 * light + 1.7) + 0.06);
        EXPECT_NEAR(picture.at(kWidth / 2, kHeight / 2)[0], expected * 255.0, 2.0);
    }
}

TEST_F(RendererTest, MoreLightsThanABatchHoldsAddUp) {
    WorldBuilder builder;
    builder.add("wall", scene::make_box({50.0F, 50.0F, 1.0F}), at({0, 0, -10}));
    std::vector<scene::PlacedLight> many;
    for (int i = 0; i < 70; ++i)
        many.push_back(lamp_light(fmt::format("lamp {}", i), {0, 0, -7}, 0.1F, 50.0F));

    const auto in_batches = draw(builder.world, camera_at({}), many);
    const auto at_once =
        draw(builder.world, camera_at({}), {lamp_light("lamp", {0, 0, -7}, 7.0F, 50.0F)});

    EXPECT_EQ(differing_bytes(in_batches, at_once, 2), 0U);
}

TEST_F(RendererTest, MirroredMeshesShowTheirOutside) {
    WorldBuilder builder;
    builder.add("box", scene::make_box({1.0F, 1.0F, 1.0F}), at({0, 0, -3}, {-1.0F, 1.0F, 1.0F}));
    scene::PlacedLight light = sun_light();
    light.direction = {0.0F, 0.0F, -1.0F};

    draw(builder.world, camera_at({}), {light});

    const float depth = gpu::read_depth(renderer_->gbuffer().depth()).at(kWidth / 2, kHeight / 2);
    EXPECT_NEAR(0.1F / depth, 2.5F, 1e-3F); // the front, not the back at 3.5 m
}

TEST_F(RendererTest, PatchesOfABoxHaveIdsOfTheirOwn) {
    WorldBuilder builder;
    const ecs::Entity box = builder.add("box", scene::make_box({1.0F, 1.0F, 1.0F}), at({0, 0, -3}));

    draw(builder.world, camera_at({}), {sun_light()});

    const auto part = renderer_->receivers().part(middle_id());
    EXPECT_EQ(part.entity, box);
    ASSERT_GT(part.patch, 0U);
    EXPECT_GT(builder.world.assets.meshes[0].patches[part.patch - 1].normal.z, 0.99F);
}

TEST_F(RendererTest, HolesOfAnAlphaMaskShowWhatIsBehind) {
    WorldBuilder builder;
    scene::Texture holes;
    holes.image = engine::Image(2, 2, 4); // clear everywhere
    builder.world.assets.textures.push_back(holes);
    scene::Material leaf;
    leaf.texture = 0;
    leaf.alpha_masked = true;
    builder.world.assets.materials.push_back(leaf);
    const ecs::Entity wall =
        builder.add("wall", scene::make_box({50.0F, 50.0F, 1.0F}), at({0, 0, -10}));
    scene::Mesh card = scene::make_box({1.0F, 1.0F, 1.0F});
    card.submeshes[0].material = 1;
    builder.add("card", std::move(card), at({0, 0, -3}));

    draw(builder.world, camera_at({}), {sun_light()});

    EXPECT_EQ(renderer_->receivers().part(middle_id()).entity, wall);
}

TEST_F(RendererTest, TenThousandObjectsAreAHandfulOfDraws) {
    WorldBuilder builder;
    builder.add("box 0", scene::make_box({0.1F, 0.1F, 0.1F}), at({0, 0, -30}));
    for (int i = 1; i < 10000; ++i)
        builder.add_instance(
            fmt::format("box {}", i), 0, at({(i % 100) * 0.3 - 15.0, (i / 100) * 0.3 - 15.0, -40}));

    draw(builder.world, camera_at({}), {sun_light()});

    EXPECT_LE(renderer_->frame().counters().draws, 4U);
    EXPECT_LE(renderer_->frame().counters().state_changes, 60U);
}

TEST_F(RendererTest, WhatIsOutOfViewIsNotDrawn) {
    WorldBuilder builder;
    builder.add("ahead", scene::make_box({1.0F, 1.0F, 1.0F}), at({0, 0, -5}));
    builder.add_instance("behind", 0, at({0, 0, 5}));

    draw(builder.world, camera_at({}), {sun_light()});

    EXPECT_EQ(
        renderer_->frame().counters().triangles, 12U + 2U); // one box, and the lighting's rectangle
}

/// Darkens the left half of the picture for one light.
class HalfDark final : public LightVisibility {
public:
    engine::Result<void> prepare(const FrameInput&) override { return {}; }
    [[nodiscard]] bool serves(std::size_t light) const override { return light == 0; }
    engine::Result<void>
    refresh(gpu::Frame&, gpu::ShaderLibrary&, const render::Geometry&) override {
        return {};
    }
    void apply(gpu::Frame& frame, std::size_t, const VisibilityTarget& target) override {
        gpu::clear_target(
            frame,
            target.mask,
            {.color = glm::vec4(0.0F), .area = gpu::Rect{0, 0, kWidth / 2, kHeight}});
    }
};

TEST_F(RendererTest, AMaskDarkensItsOwnLightAndNoOther) {
    WorldBuilder builder;
    builder.add("wall", scene::make_box({50.0F, 50.0F, 1.0F}), at({0, 0, -10}));
    builder.world.ambient = glm::vec3(0.0F);
    scene::PlacedLight first = sun_light(1.0F);
    first.direction = {0.0F, 0.0F, -1.0F};
    scene::PlacedLight second = first;
    second.name = "second";
    HalfDark half;

    const auto both = draw(builder.world, camera_at({}), {first, second}, &half);
    const auto alone = draw(builder.world, camera_at({}), {second});

    EXPECT_NEAR(both.at(10, 60)[0], alone.at(10, 60)[0], 1);
    EXPECT_GT(both.at(150, 60)[0], both.at(10, 60)[0] + 20);
}

TEST_F(RendererTest, AMaskCanBeDrawnByItself) {
    WorldBuilder builder;
    builder.add("wall", scene::make_box({50.0F, 50.0F, 1.0F}), at({0, 0, -10}));
    HalfDark half;
    draw(builder.world, camera_at({}), {sun_light(), sun_light()}, &half);

    const auto served = renderer_->draw_mask(0, half);
    const auto unserved = renderer_->draw_mask(1, half);

    EXPECT_EQ(served->at(10, 60)[0], 0);
    EXPECT_EQ(served->at(150, 60)[0], 255);
    EXPECT_EQ(unserved->at(10, 60)[0], 255);
}

TEST_F(RendererTest, AnEmptyWorldIsDrawn) {
    scene::World world;

    const auto picture = draw(world, camera_at({}), {});

    EXPECT_EQ(picture.at(0, 0)[3], 255);
}

} // namespace
} // namespace render
