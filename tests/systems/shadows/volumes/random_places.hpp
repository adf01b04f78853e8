// Directions for property tests.

#pragma once

#include "engine/core/random.hpp"

#include <glm/glm.hpp>

namespace shadows {

inline glm::dvec3 unit_vector(engine::Random& random) {
    for (;;) {
        const glm::dvec3 v(
            random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        const double length = glm::length(v);
        if (length > 0.1 && length < 1.0) return v / length;
    }
}

} // namespace shadows
