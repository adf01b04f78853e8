#include "engine/gpu/handle.hpp"

#include <algorithm>
#include <atomic>

namespace gpu {

namespace {

// Objects outlive the frame that made them and know no context, so their sum belongs to the
// process.
std::atomic<std::uint64_t> total_bytes =
    0; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): see above

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
