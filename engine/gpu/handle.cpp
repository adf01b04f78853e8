#include "engine/gpu/handle.hpp"

#include <algorithm>
#include <atomic>

namespace gpu {

namespace {

// Objects know no context, so the sum of their bytes belongs to the process.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<std::uint64_t> total_bytes = 0;

// OpenGL 4.5, table 23.68: the least value of MAX_LABEL_LENGTH, terminator included.
constexpr std::size_t kMaxLabelBytes = 255;

} // namespace

void label_object(GLenum kind, GLuint name, std::string_view label) {
    const std::size_t length = std::min(label.size(), kMaxLabelBytes);
    glObjectLabel(kind, name, static_cast<GLsizei>(length), label.data());
}

std::uint64_t device_bytes() {
    return total_bytes;
}

DeviceBytes::DeviceBytes(std::uint64_t bytes) : bytes_(bytes) {
    total_bytes += bytes;
}

DeviceBytes::~DeviceBytes() {
    total_bytes -= bytes_;
}

} // namespace gpu
