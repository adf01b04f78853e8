// Real models, where a folder of them is at hand: all of them are drawn or refused, and animated
// ones move alike in the rasteriser and in the truth.

#include "engine/scene/views.hpp"
#include "tests/support/assets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tools/gnomon/comparing.hpp"

namespace gnomon {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

bool has_opengl() {
    static const bool has = Studio::open(kWidth, kHeight).has_value();
    return has;
}

class Models : public testing::Test {
protected:
    void SetUp() override {
        if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
        if (test_support::assets_folder().empty())
            GTEST_SKIP() << "no folder of models; GNOMON_ASSETS may name one";
    }

    static std::filesystem::path file(const std::string& name) {
        return test_support::assets_folder() / name;
    }
};

struct Drawn {
    measure::Comparison comparison;
    std::vector<std::uint32_t> ids;
};

Drawn draw_and_trace(Level& level) {
    const scene::CameraView camera = *choose_camera(level, "", kWidth, kHeight);
    const auto opened = Studio::open(kWidth, kHeight);
    Studio& one = **opened;
    EXPECT_TRUE(one.draw(level, camera, false));
    const trace::TraceScene tracer(level.world);
    const auto truth = truth::true_visibility(tracer, camera, one.lights().front());
    const engine::Image lit(kWidth, kHeight, 1);
    return {
        make_comparison(lit, truth, drawn_surfaces(one, camera), camera, one.lights().front()),
        one.receiver_ids()};
}

double invalid_share(const measure::Comparison& comparison) {
    const auto count = [&](measure::PixelKind kind) {
        return static_cast<double>(
            std::count(comparison.kind.begin(), comparison.kind.end(), kind));
    };
    const double surface =
        static_cast<double>(comparison.kind.size()) - count(measure::PixelKind::empty);
    return count(measure::PixelKind::mismatch) / surface;
}

class AnimatedModels : public Models, public testing::WithParamInterface<const char*> {};

TEST_P(AnimatedModels, MoveAlikeInRasterAndTruth) {
    auto level = load_level(file(GetParam()));
    ASSERT_TRUE(level);
    const Drawn at_rest = draw_and_trace(*level);
    ASSERT_LT(invalid_share(at_rest.comparison), 0.02);

    for (int step = 0; step < 3; ++step) {
        scene::update(level->world, 0.17F);
        const Drawn moved = draw_and_trace(*level);
        EXPECT_LT(invalid_share(moved.comparison), 0.02) << "step " << step;
        EXPECT_NE(moved.ids, at_rest.ids) << "nothing moved";
    }
}

INSTANTIATE_TEST_SUITE_P(
    Files,
    AnimatedModels,
    testing::Values(
        "knight/Knight.glb",
        "fox/Fox.glb",
        "morph_cube/AnimatedMorphCube.gltf",
        "cesium_man/CesiumMan.glb"));

TEST_F(Models, EachIsDrawnOrRefusedWithASentence) {
    int drawn = 0;
    int refused = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(test_support::assets_folder())) {
        const auto kind = entry.path().extension();
        if (kind != ".glb" && kind != ".gltf") continue;
        SCOPED_TRACE(entry.path().string());
        auto level = load_level(entry.path());
        if (!level) {
            ++refused;
            EXPECT_GT(level.error().message.size(), 20U);
            continue;
        }
        const auto one = Studio::open(kWidth, kHeight);
        const auto camera = *choose_camera(*level, "", kWidth, kHeight);
        EXPECT_TRUE((*one)->draw(*level, camera));
        const auto ids = (*one)->receiver_ids();
        EXPECT_TRUE(std::any_of(ids.begin(), ids.end(), [](std::uint32_t id) { return id != 0; }))
            << "nothing is seen";
        ++drawn;
    }
    EXPECT_GE(drawn, 30);
    EXPECT_EQ(refused, 4); // infinite, out of range twice, recursive
}

} // namespace
} // namespace gnomon
