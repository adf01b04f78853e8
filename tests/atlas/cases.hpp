// The cases, one function per technique, and what they share.

#pragma once

#include "tests/atlas/atlas.hpp"
#include "tests/support/worlds.hpp"

namespace atlas {

/// A point light named "lamp" that reaches everything.
inline scene::PlacedLight lamp_at(const glm::dvec3& position) {
    return test_support::lamp_light("lamp", position, 100.0F, 1000.0F);
}

/// A material that is opaque in a disc alone, as the world's second. Adds its texture as the first.
void add_leaf_material(test_support::WorldBuilder& builder);

std::vector<Case> control_cases();
std::vector<Case> blob_cases();
std::vector<Case> map_cases();
std::vector<Case> map_depth_cases();
std::vector<Case> map_bias_cases();
std::vector<Case> map_texel_cases();
std::vector<Case> map_motion_cases();
std::vector<Case> planar_cases();
std::vector<Case> soft_cases();
std::vector<Case> sheet_cases();
std::vector<Case> soft_planar_cases();
std::vector<Case> texture_cases();
std::vector<Case> volume_cases();
std::vector<Case> volume_mesh_cases();

std::vector<Refusal> refusals();
std::vector<Impossible> impossible();

inline std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const auto& some :
         {control_cases(),
          blob_cases(),
          map_cases(),
          map_depth_cases(),
          map_bias_cases(),
          map_texel_cases(),
          map_motion_cases(),
          planar_cases(),
          soft_cases(),
          sheet_cases(),
          soft_planar_cases(),
          texture_cases(),
          volume_cases(),
          volume_mesh_cases()})
        cases.insert(cases.end(), some.begin(), some.end());
    return cases;
}

} // namespace atlas
