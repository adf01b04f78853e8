// The cases, one function per technique.

#pragma once

#include "tests/atlas/atlas.hpp"

namespace atlas {

std::vector<Case> control_cases();
std::vector<Case> blob_cases();
std::vector<Case> map_cases();
std::vector<Case> planar_cases();
std::vector<Case> texture_cases();
std::vector<Case> volume_cases();

inline std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const auto& some :
         {control_cases(),
          blob_cases(),
          map_cases(),
          planar_cases(),
          texture_cases(),
          volume_cases()})
        cases.insert(cases.end(), some.begin(), some.end());
    return cases;
}

} // namespace atlas
