// What a driver really does, tried at start-up where drivers have been wrong.

#pragma once

namespace gpu {

struct DriverProbe {
    /// Depth clamp keeps what lies in front of the near plane or beyond clip space's far side, at
    /// depth 1 or 0.
    bool clamps_depth = false;
    /// Two-sided stencil wraps: a back face that counts down from 0 and a front face that counts up
    /// again meet at 0 in one draw.
    bool wraps_stencil = false;
};

/// Draws a few pixels into targets of its own. Needs a current context; call it outside of a frame
/// and make the Frame afterwards, or have its StateCache forget.
DriverProbe probe_driver();

} // namespace gpu
