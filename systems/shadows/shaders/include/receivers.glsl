// Which receivers a job serves: one bit for each receiver id, set from its plans. A job writes no other pixel.

#include "shadows/shared/receivers.h"

layout(std430, binding = RECEIVER_BITS_BINDING) readonly buffer ReceiverBits {
    uint receiver_words[];
};

bool serves(uint receiver) {
    return ((receiver_words[receiver >> 5] >> (receiver & 31u)) & 1u) != 0u;
}
