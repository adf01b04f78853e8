// Stages that stencil volumes serve.

#pragma once

#include "tests/atlas/cases.hpp"

namespace atlas {

/// The floor is served, and what else is named.
inline Stage served(
    test_support::WorldBuilder& builder,
    const std::string& light,
    const std::string& other = "floor") {
    Stage stage = pinned_stage(
        std::move(builder.world),
        test_support::usual_camera(kPictureSize),
        light,
        "floor",
        "volume");
    stage.level.shadows.receivers[other].technique = "volume";
    return stage;
}

} // namespace atlas
