#include "engine/scene/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace scene {

namespace {

template <class T>
T load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// An integer as it is, or over its largest value. Source: glTF 2.0 specification, 3.6.2.2 and 3.11
/// (-128 gives -1).
template <class T>
float integer(const std::uint8_t* bytes, bool normalized) {
    const T value = load<T>(bytes);
    if (!normalized) return static_cast<float>(value);
    return static_cast<float>(std::max(
        static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0));
}

float number(const std::uint8_t* bytes, int component_type, bool normalized) {
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return integer<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return integer<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return integer<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return integer<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return integer<std::uint32_t>(bytes, normalized);
    default:
        return load<float>(bytes);
    }
}

std::uint32_t whole_number(const std::uint8_t* bytes, int component_type) {
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(bytes);
    default:
        return load<std::uint32_t>(bytes);
    }
}

/// 0 for types that glTF does not know.
std::size_t component_bytes(int component_type) {
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        return 0;
    }
}

bool is_whole(int component_type) {
    return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
           || component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
           || component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Elements at a stride, all of them inside their buffer view.
struct Elements {
    const std::uint8_t* first = nullptr;
    std::size_t stride = 0;
};

/// @param stride 0: as tight as the elements
engine::Result<Elements> elements(
    const tinygltf::Model& source,
    int view,
    std::uint64_t offset,
    std::uint64_t stride,
    std::uint64_t count,
    std::uint64_t element_bytes) {
    const auto bytes = view_bytes(source, view);
    if (!bytes) return bytes.error();
    if (stride == 0) stride = element_bytes;
    if (stride < element_bytes)
        return engine::Error{fmt::format(
            "a stride of {} bytes is less than its elements of {} bytes", stride, element_bytes)};
    // Offsets, strides and counts are below 2^31 (gltf_text), so that 64 bits hold the sum.
    const std::uint64_t end = offset + (count - 1) * stride + element_bytes;
    if (end > bytes->size())
        return engine::Error{fmt::format(
            "its {} elements end at byte {} of a buffer view of {} bytes",
            count,
            end,
            bytes->size())};
    return Elements{bytes->data() + offset, stride};
}

engine::Result<void> check_shape(const tinygltf::Accessor& accessor, int width, bool whole) {
    const int found = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    const bool matrix = (accessor.type & 32) != 0 && accessor.type != TINYGLTF_TYPE_MAT4;
    if (found != width || matrix)
        return engine::Error{
            fmt::format("its elements have {} components, expected {}", found, width)};
    if (component_bytes(accessor.componentType) == 0)
        return engine::Error{fmt::format("component type {} is not known", accessor.componentType)};
    if (whole && (!is_whole(accessor.componentType) || accessor.normalized))
        return engine::Error{fmt::format(
            "component type {}{} where unsigned integers are expected",
            accessor.componentType,
            accessor.normalized ? ", normalised," : "")};
    if (accessor.count == 0) return engine::Error{"it has no elements"};
    return {};
}

/// How an element is stored.
struct Format {
    int component_type;
    bool normalized;
    std::size_t components;

    [[nodiscard]] std::size_t bytes() const { return component_bytes(component_type) * components; }

    template <class T>
    void decode(const std::uint8_t* from, T* to) const {
        for (std::size_t i = 0; i < components; ++i, from += component_bytes(component_type)) {
            if constexpr (std::is_integral_v<T>)
                to[i] = whole_number(from, component_type);
            else
                to[i] = number(from, component_type, normalized);
        }
    }
};

template <class T>
engine::Result<void> replace_sparse(
    const tinygltf::Model& source,
    const tinygltf::Accessor& accessor,
    const Format& format,
    std::vector<T>& result) {
    const auto& sparse = accessor.sparse;
    const int place_type = sparse.indices.componentType;
    if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > accessor.count)
        return engine::Error{fmt::format("{} sparse elements of {}", sparse.count, accessor.count)};
    if (!is_whole(place_type))
        return engine::Error{fmt::format("sparse indices of component type {}", place_type)};
    const auto count = static_cast<std::uint64_t>(sparse.count);
    const auto places = elements(
        source,
        sparse.indices.bufferView,
        static_cast<std::uint64_t>(sparse.indices.byteOffset),
        0,
        count,
        component_bytes(place_type));
    if (!places) return places.error();
    const auto values = elements(
        source,
        sparse.values.bufferView,
        static_cast<std::uint64_t>(sparse.values.byteOffset),
        0,
        count,
        format.bytes());
    if (!values) return values.error();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = whole_number(places->first + i * places->stride, place_type);
        if (place >= accessor.count)
            return engine::Error{fmt::format(
                "sparse index {} at {} is past its {} elements", place, i, accessor.count)};
        format.decode(values->first + i * values->stride, &result[place * format.components]);
    }
    return {};
}

} // namespace

engine::Result<std::span<const std::uint8_t>> view_bytes(const tinygltf::Model& source, int view) {
    if (view < 0 || static_cast<std::size_t>(view) >= source.bufferViews.size())
        return engine::Error{
            fmt::format("buffer view {} of {} does not exist", view, source.bufferViews.size())};
    const tinygltf::BufferView& found = source.bufferViews[static_cast<std::size_t>(view)];
    if (found.buffer < 0 || static_cast<std::size_t>(found.buffer) >= source.buffers.size())
        return engine::Error{fmt::format(
            "buffer view {} asks for buffer {} of {}", view, found.buffer, source.buffers.size())};
    const auto& bytes = source.buffers[static_cast<std::size_t>(found.buffer)].data;
    if (found.byteOffset > bytes.size() || found.byteLength > bytes.size() - found.byteOffset)
        return engine::Error{fmt::format(
            "buffer view {} ends at byte {} of a buffer of {} bytes",
            view,
            found.byteOffset + found.byteLength,
            bytes.size())};
    return std::span(bytes).subspan(found.byteOffset, found.byteLength);
}

template <class T>
engine::Result<std::vector<T>> AccessorReader::read(int index, int width) const {
    if (index < 0 || static_cast<std::size_t>(index) >= source_->accessors.size())
        return engine::Error{
            fmt::format("accessor {} of {} does not exist", index, source_->accessors.size())};
    const tinygltf::Accessor& accessor = source_->accessors[static_cast<std::size_t>(index)];
    if (const auto checked = check_shape(accessor, width, std::is_integral_v<T>); !checked)
        return checked.error();

    const Format format{
        accessor.componentType, accessor.normalized, static_cast<std::size_t>(width)};
    Elements dense;
    if (accessor.bufferView >= 0) {
        const auto view = static_cast<std::size_t>(accessor.bufferView);
        const std::size_t stride =
            view < source_->bufferViews.size() ? source_->bufferViews[view].byteStride : 0;
        const auto found = elements(
            *source_,
            accessor.bufferView,
            accessor.byteOffset,
            stride,
            accessor.count,
            format.bytes());
        if (!found) return found.error();
        dense = *found;
    }
    if (!budget_->take(std::uint64_t{accessor.count} * format.components * sizeof(T)))
        return engine::Error{fmt::format(
            "its {} elements are more than a model of this size may unpack", accessor.count)};
    std::vector<T> result(accessor.count * format.components);
    if (dense.first)
        for (std::size_t i = 0; i < accessor.count; ++i)
            format.decode(dense.first + i * dense.stride, &result[i * format.components]);
    if (accessor.sparse.isSparse)
        if (const auto replaced = replace_sparse(*source_, accessor, format, result); !replaced)
            return replaced.error();
    return result;
}

engine::Result<std::vector<float>> AccessorReader::floats(int accessor, int width) const {
    auto numbers = floats_as_found(accessor, width);
    if (!numbers) return numbers;
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        const auto value = static_cast<double>((*numbers)[i]);
        if (std::abs(value) <= kLargestNumber) continue;
        const std::size_t element = i / static_cast<std::size_t>(width);
        if (!std::isfinite(value))
            return engine::Error{fmt::format("element {} is not finite", element)};
        return engine::Error{fmt::format(
            "element {} is {:g}, expected at most {:g}", element, value, kLargestNumber)};
    }
    return numbers;
}

engine::Result<std::vector<float>> AccessorReader::floats_as_found(int accessor, int width) const {
    return read<float>(accessor, width);
}

engine::Result<std::vector<std::uint32_t>> AccessorReader::integers(int accessor, int width) const {
    return read<std::uint32_t>(accessor, width);
}

} // namespace scene
