#include "systems/shadows/techniques/receiver_bits.hpp"

#include "engine/core/check.hpp"

#include <shadows/shared/receivers.h>

namespace shadows {

ReceiverBits::ReceiverBits() : buffer_(gpu::Buffer::dynamic("receiver bits")) {}

void ReceiverBits::assign(std::span<const Plan* const> plans, std::uint32_t receiver_end) {
    std::vector<std::uint32_t> receivers;
    receivers.reserve(plans.size());
    for (const Plan* plan : plans)
        receivers.push_back(plan->receiver);
    assign(receivers, receiver_end);
}

void ReceiverBits::assign(std::span<const std::uint32_t> receivers, std::uint32_t receiver_end) {
    std::vector<std::uint32_t> words(receiver_end / 32 + 1);
    for (const std::uint32_t receiver : receivers) {
        CHECK_LT(receiver, receiver_end);
        words[receiver / 32] |= 1U << (receiver % 32);
    }
    if (words == words_) return;
    buffer_.assign(gpu::bytes_of(words));
    words_ = std::move(words);
}

void ReceiverBits::bind() const {
    buffer_.bind_storage(RECEIVER_BITS_BINDING);
}

} // namespace shadows
