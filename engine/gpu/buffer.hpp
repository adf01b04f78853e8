// A buffer on the device: vertices, indices, uniform blocks, storage blocks.

#pragma once

#include "engine/gpu/handle.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace gpu {

/// The bytes of an array or of one plain value, to hand to a buffer.
template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}
template <class T>
std::span<const std::byte> bytes_of_value(const T& value) {
    return std::as_bytes(std::span<const T, 1>(&value, 1));
}

/// Empty when default constructed; may not be bound then.
class Buffer {
public:
    Buffer() = default;

    /// A buffer whose contents never change.
    static Buffer fixed(std::string_view label, std::span<const std::byte> contents);

    /// A buffer rewritten now and then, every frame at most. Its contents are undefined until
    /// written.
    static Buffer dynamic(std::string_view label, std::size_t size_bytes = 0);

    /// Makes `contents` the whole contents: draws in flight keep the old ones, the store grows to
    /// the next power of two when it is too small, and the name stays. @pre made by dynamic()
    void assign(std::span<const std::byte> contents);

    /// Overwrites a part. @pre made by dynamic(); offset + contents.size() <= capacity_bytes()
    void write(std::size_t offset_bytes, std::span<const std::byte> contents);

    /// Sets every byte to zero. @pre made by dynamic()
    void clear();

    /// Binds the whole buffer, or a part of it, to a uniform or storage block's binding point.
    void bind_uniform(unsigned binding) const;
    void bind_uniform(unsigned binding, std::size_t offset_bytes, std::size_t size_bytes) const;
    void bind_storage(unsigned binding) const;

    /// Waits for the device. @return the first contents.size() bytes
    void read(std::span<std::byte> contents, std::size_t offset_bytes = 0) const;

    [[nodiscard]] GLuint name() const { return handle_.name(); }
    [[nodiscard]] std::size_t size_bytes() const { return size_bytes_; } ///< of the contents
    [[nodiscard]] std::size_t capacity_bytes() const { return device_bytes_.count(); }
    explicit operator bool() const { return static_cast<bool>(handle_); }

private:
    BufferHandle handle_;
    DeviceBytes device_bytes_;
    std::size_t size_bytes_ = 0;
    bool dynamic_ = false;
};

} // namespace gpu
