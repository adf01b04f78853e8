// The instrument itself: truth against truth must show no error at all.

#include "tests/atlas/cases.hpp"
#include "tests/support/worlds.hpp"

namespace atlas {

namespace {

Stage traced_stage(double height) {
    test_support::WorldBuilder builder = test_support::floor_of(20.0F);
    builder.add("ball", scene::make_sphere(0.5F), test_support::at({0.0, height, 0.0}));
    builder.add_light(test_support::sun_light());
    return pinned_stage(
        std::move(builder.world),
        test_support::usual_camera(kPictureSize),
        "sun",
        "floor",
        "traced");
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
