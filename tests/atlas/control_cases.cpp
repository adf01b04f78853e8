// The instrument itself: truth against truth must show no error at all.

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

namespace atlas {

namespace {

Stage traced_stage(double height) {
    test_support::WorldBuilder builder;
    builder.add("floor", scene::make_plane({20.0F, 20.0F}));
    builder.add("ball", scene::make_sphere(0.5F), test_support::at({0.0, height, 0.0}));
    builder.add_light(test_support::sun_light());
    const auto camera =
        test_support::camera_looking({0.0, 3.0, 8.0}, {0.0, 0.5, 0.0}, kPictureSize, kPictureSize);
    return pinned_stage(std::move(builder.world), camera, "sun", "floor", "traced");
}

} // namespace

std::vector<Case> control_cases() {
    return {
        {.id = "Control",
         .sentence = "truth differs from truth: the instrument is broken",
         .build = traced_stage,
         .sweep = {0.5, 2.5, 1.0},
         .remedy = std::nullopt,
         .gates = exact_shape()}};
}

} // namespace atlas
