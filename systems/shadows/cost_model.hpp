// Counts into milliseconds. Decisions use committed coefficients, never measured time, so that the
// same frame is planned alike on every machine.

#pragma once

#include "systems/shadows/plan.hpp"

namespace shadows {

/// What one of each costs on a device, in milliseconds.
struct DeviceProfile {
    Cost ms_per;
};

/// Mesa llvmpipe on two cores at 1280x720.
DeviceProfile llvmpipe_profile();

/// The predicted time of some work: the sum of counts times coefficients.
double milliseconds(const Cost& cost, const DeviceProfile& profile);

} // namespace shadows
