#include "engine/gpu/state.hpp"

#include <gtest/gtest.h>

namespace gpu {
namespace {

/// The only group in which the two states differ, or `count` when there are none or several.
StateGroup only_difference(const RenderState& from, const RenderState& to) {
    const StateGroups groups = difference(from, to);
    if (groups.count() != 1) return StateGroup::count;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i]) return static_cast<StateGroup>(i);
    }
    return StateGroup::count;
}

TEST(RenderState, EqualStatesDifferInNothing) {
    const RenderState state = {
        .stencil = Stencil{}, .blend = Blend::min, .scissor = Rect{1, 2, 3, 4}};

    EXPECT_TRUE(difference(state, RenderState(state)).none());
}

struct DifferenceCase {
    const char* name;
    RenderState state;
    StateGroup group;
};

class StateDifference : public testing::TestWithParam<DifferenceCase> {};

TEST_P(StateDifference, IsFoundInItsGroupAlone) {
    EXPECT_EQ(only_difference({}, GetParam().state), GetParam().group);
}

INSTANTIATE_TEST_SUITE_P(
    Fields,
    StateDifference,
    testing::Values(
        DifferenceCase{"DepthTest", {.depth_test = Compare::equal}, StateGroup::depth_test},
        DifferenceCase{"DepthWrite", {.depth_write = false}, StateGroup::depth_test},
        DifferenceCase{"DepthClamp", {.depth_clamp = false}, StateGroup::depth_clamp},
        DifferenceCase{"Cull", {.cull = Cull::front}, StateGroup::cull},
        DifferenceCase{"FrontFace", {.front_face = FrontFace::clockwise}, StateGroup::front_face},
        DifferenceCase{"ColorWrite", {.color_write = kWriteRed}, StateGroup::color_write},
        DifferenceCase{
            "StencilReference", {.stencil = Stencil::both({.reference = 1})}, StateGroup::stencil},
        DifferenceCase{"Blend", {.blend = Blend::min}, StateGroup::blend},
        DifferenceCase{"Scissor", {.scissor = Rect{0, 0, 1, 1}}, StateGroup::scissor},
        DifferenceCase{"Viewport", {.viewport = Rect{0, 0, 1, 1}}, StateGroup::viewport},
        DifferenceCase{"ClipDistances", {.clip_distances = 2}, StateGroup::clip_distances},
        DifferenceCase{"Wireframe", {.wireframe = true}, StateGroup::wireframe}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(RenderState, StencilFacesAreToldApart) {
    const RenderState front = {.stencil = Stencil{.front = {.on_pass = StencilOp::increment_wrap}}};
    const RenderState back = {.stencil = Stencil{.back = {.on_pass = StencilOp::increment_wrap}}};

    EXPECT_EQ(only_difference(front, back), StateGroup::stencil);
}

} // namespace
} // namespace gpu
