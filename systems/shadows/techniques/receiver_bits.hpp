// The receivers of a job's plans as a bit field on the device; include/receivers.glsl reads it.

#pragma once

#include "engine/gpu/buffer.hpp"
#include "systems/shadows/plan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace shadows {

class ReceiverBits {
public:
    ReceiverBits();

    /// @param receiver_end one past the highest receiver id of the frame
    void assign(std::span<const Plan* const> plans, std::uint32_t receiver_end);
    /// @param receivers ids
    void assign(std::span<const std::uint32_t> receivers, std::uint32_t receiver_end);
    void bind() const;

private:
    gpu::Buffer buffer_;
    std::vector<std::uint32_t> words_;
};

} // namespace shadows
