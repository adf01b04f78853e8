// What the cases of maps share.

#pragma once

#include "tests/atlas/cases.hpp"

namespace atlas {

/// A stage with one map of a size. @param size texels per side
Stage one_map(
    test_support::WorldBuilder& builder,
    const scene::CameraView& camera,
    const std::string& light,
    const std::string& receiver,
    const std::string& technique,
    int size);

Gate false_shadow_at_most(double px);
Gate light_leak_at_most(double px);
/// What is lit and yet less than `visibility` in the picture.
Gate dimmed_at_most(double px, double visibility = 0.75);
/// Wrong pixels farther from true edges than the map's resolution explains: none.
std::vector<Gate> right_beyond_texels();
/// Dark in truth and lit in the picture, of all that is dark, edges included.
Gate lit_share_of_shadow(double at_most);

} // namespace atlas
