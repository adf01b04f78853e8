// Every way in which a glTF accessor can store its numbers.

#include "engine/scene/accessor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A file of one accessor over one buffer view over one buffer.
template <class T>
tinygltf::Model
file_of(const std::vector<T>& numbers, int component_type, int type, std::size_t count) {
    tinygltf::Model model;
    tinygltf::Buffer buffer;
    buffer.data.resize(numbers.size() * sizeof(T));
    std::memcpy(buffer.data.data(), numbers.data(), buffer.data.size());
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = 0;
    view.byteLength = buffer.data.size();
    view.byteStride = 0;
    tinygltf::Accessor accessor;
    accessor.bufferView = 0;
    accessor.componentType = component_type;
    accessor.type = type;
    accessor.count = count;
    model.buffers.push_back(buffer);
    model.bufferViews.push_back(view);
    model.accessors.push_back(accessor);
    return model;
}

tinygltf::Model four_floats() {
    return file_of<float>({1, 2, 3, 4}, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, 2);
}

std::vector<float> floats(const tinygltf::Model& model, int width) {
    scene::MemoryBudget budget(1000);
    const auto numbers = scene::AccessorReader(model, budget).floats(0, width);
    if (numbers) return *numbers;
    ADD_FAILURE() << numbers.error().message;
    return {};
}

std::string refusal(const tinygltf::Model& model, int width, std::uint64_t budget_bytes = 1000) {
    scene::MemoryBudget budget(budget_bytes);
    const auto numbers = scene::AccessorReader(model, budget).floats(0, width);
    return numbers ? "read" : numbers.error().message;
}

std::string refusal_of_integers(const tinygltf::Model& model) {
    scene::MemoryBudget budget(1000);
    const auto numbers = scene::AccessorReader(model, budget).integers(0, 1);
    return numbers ? "read" : numbers.error().message;
}

/// Replaces elements 1 by (8, 9).
tinygltf::Model sparse_file(std::uint8_t place) {
    tinygltf::Model model = four_floats();
    tinygltf::Buffer buffer;
    const float values[] = {8, 9};
    buffer.data.resize(12);
    buffer.data[0] = place;
    std::memcpy(buffer.data.data() + 4, values, sizeof values);
    model.buffers.push_back(buffer);
    tinygltf::BufferView view;
    view.buffer = 1;
    view.byteOffset = 0;
    view.byteLength = 12;
    view.byteStride = 0;
    model.bufferViews.push_back(view);
    auto& sparse = model.accessors[0].sparse;
    sparse.isSparse = true;
    sparse.count = 1;
    sparse.indices.bufferView = 1;
    sparse.indices.byteOffset = 0;
    sparse.indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    sparse.values.bufferView = 1;
    sparse.values.byteOffset = 4;
    return model;
}

struct NumberCase {
    const char* name;
    tinygltf::Model model;
    bool normalized;
    std::vector<float> expected;
};

class AccessorNumbers : public testing::TestWithParam<NumberCase> {};

TEST_P(AccessorNumbers, AreReadByTheirType) {
    tinygltf::Model model = GetParam().model;
    model.accessors[0].normalized = GetParam().normalized;

    EXPECT_EQ(floats(model, 1), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Accessor,
    AccessorNumbers,
    testing::Values(
        NumberCase{
            "bytes",
            file_of<std::int8_t>({-128, 5}, 5120, TINYGLTF_TYPE_SCALAR, 2),
            false,
            {-128, 5}},
        NumberCase{
            "normalised_bytes",
            file_of<std::int8_t>({-128, 127}, 5120, TINYGLTF_TYPE_SCALAR, 2),
            true,
            {-1, 1}},
        NumberCase{
            "unsigned_bytes",
            file_of<std::uint8_t>({0, 255}, 5121, TINYGLTF_TYPE_SCALAR, 2),
            false,
            {0, 255}},
        NumberCase{
            "normalised_unsigned_bytes",
            file_of<std::uint8_t>({0, 51}, 5121, TINYGLTF_TYPE_SCALAR, 2),
            true,
            {0, 0.2F}},
        NumberCase{
            "shorts",
            file_of<std::int16_t>({-32768, 7}, 5122, TINYGLTF_TYPE_SCALAR, 2),
            false,
            {-32768, 7}},
        NumberCase{
            "normalised_shorts",
            file_of<std::int16_t>({-32768, 32767}, 5122, TINYGLTF_TYPE_SCALAR, 2),
            true,
            {-1, 1}},
        NumberCase{
            "unsigned_shorts",
            file_of<std::uint16_t>({65535}, 5123, TINYGLTF_TYPE_SCALAR, 1),
            false,
            {65535}},
        NumberCase{
            "normalised_unsigned_shorts",
            file_of<std::uint16_t>({13107}, 5123, TINYGLTF_TYPE_SCALAR, 1),
            true,
            {0.2F}},
        NumberCase{
            "unsigned_ints",
            file_of<std::uint32_t>({70000}, 5125, TINYGLTF_TYPE_SCALAR, 1),
            false,
            {70000}},
        NumberCase{
            "floats",
            file_of<float>({-1.5F, 2.25F}, 5126, TINYGLTF_TYPE_SCALAR, 2),
            false,
            {-1.5F, 2.25F}}),
    [](const auto& test) { return test.param.name; });

TEST(Accessor, StridesSkipWhatLiesBetween) {
    tinygltf::Model model = file_of<float>({1, 2, -1, -1, 3, 4}, 5126, TINYGLTF_TYPE_VEC2, 2);
    model.bufferViews[0].byteStride = 16;

    EXPECT_THAT(floats(model, 2), ElementsAre(1, 2, 3, 4));
}

TEST(Accessor, OffsetsOfViewAndAccessorAddUp) {
    tinygltf::Model model = file_of<float>({9, 9, 1, 2}, 5126, TINYGLTF_TYPE_VEC2, 1);
    model.bufferViews[0].byteOffset = 4;
    model.bufferViews[0].byteLength = 12;
    model.accessors[0].byteOffset = 4;

    EXPECT_THAT(floats(model, 2), ElementsAre(1, 2));
}

TEST(Accessor, SparseElementsReplaceOthers) {
    EXPECT_THAT(floats(sparse_file(1), 2), ElementsAre(1, 2, 8, 9));
}

TEST(Accessor, SparseElementsWithoutABaseReplaceZeros) {
    tinygltf::Model model = sparse_file(1);
    model.accessors[0].bufferView = -1;

    EXPECT_THAT(floats(model, 2), ElementsAre(0, 0, 8, 9));
}

TEST(Accessor, RefusesSparseIndicesPastTheEnd) {
    EXPECT_EQ(refusal(sparse_file(2), 2), "sparse index 2 at 0 is past its 2 elements");
}

TEST(Accessor, RefusesSparseValuesPastTheirView) {
    tinygltf::Model model = sparse_file(1);
    model.accessors[0].sparse.values.byteOffset = 8;

    EXPECT_EQ(refusal(model, 2), "its 1 elements end at byte 16 of a buffer view of 12 bytes");
}

TEST(Accessor, RefusesMoreSparseElementsThanElements) {
    tinygltf::Model model = sparse_file(1);
    model.accessors[0].sparse.count = 3;

    EXPECT_EQ(refusal(model, 2), "3 sparse elements of 2");
}

TEST(Accessor, RefusesElementsPastTheView) {
    tinygltf::Model model = four_floats();
    model.accessors[0].count = 3;

    EXPECT_EQ(refusal(model, 2), "its 3 elements end at byte 24 of a buffer view of 16 bytes");
}

TEST(Accessor, RefusesCountsNearTheEndOfIntegers) {
    tinygltf::Model model = four_floats();
    model.accessors[0].count = 0x7FFFFFFF;
    model.bufferViews[0].byteStride = 252;

    EXPECT_THAT(refusal(model, 2), HasSubstr("end at byte 541165878800"));
}

TEST(Accessor, RefusesViewsPastTheBuffer) {
    tinygltf::Model model = four_floats();
    model.bufferViews[0].byteOffset = 4;

    EXPECT_EQ(refusal(model, 2), "buffer view 0 ends at byte 20 of a buffer of 16 bytes");
}

TEST(Accessor, RefusesStridesSmallerThanElements) {
    tinygltf::Model model = four_floats();
    model.bufferViews[0].byteStride = 4;

    EXPECT_EQ(refusal(model, 2), "a stride of 4 bytes is less than its elements of 8 bytes");
}

TEST(Accessor, RefusesWhatDoesNotExist) {
    tinygltf::Model without_view = four_floats();
    without_view.accessors[0].bufferView = 7;
    tinygltf::Model without_buffer = four_floats();
    without_buffer.bufferViews[0].buffer = 3;

    EXPECT_EQ(refusal(without_view, 2), "buffer view 7 of 1 does not exist");
    EXPECT_EQ(refusal(without_buffer, 2), "buffer view 0 asks for buffer 3 of 1");
    EXPECT_EQ(refusal({}, 2), "accessor 0 of 0 does not exist");
}

TEST(Accessor, RefusesAnotherShape) {
    tinygltf::Model doubles = four_floats();
    doubles.accessors[0].componentType = TINYGLTF_COMPONENT_TYPE_DOUBLE;
    tinygltf::Model empty = four_floats();
    empty.accessors[0].count = 0;

    EXPECT_EQ(refusal(four_floats(), 3), "its elements have 2 components, expected 3");
    EXPECT_EQ(refusal(doubles, 2), "component type 5130 is not known");
    EXPECT_EQ(refusal(empty, 2), "it has no elements");
}

TEST(Accessor, RefusesNumbersThatAreNone) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float none = std::numeric_limits<float>::quiet_NaN();

    EXPECT_EQ(
        refusal(file_of<float>({1, infinity}, 5126, TINYGLTF_TYPE_SCALAR, 2), 1),
        "element 1 is not finite");
    EXPECT_EQ(
        refusal(file_of<float>({none}, 5126, TINYGLTF_TYPE_SCALAR, 1), 1),
        "element 0 is not finite");
    EXPECT_EQ(
        refusal(file_of<float>({1, -2e9F}, 5126, TINYGLTF_TYPE_SCALAR, 2), 1),
        "element 1 is -2e+09, expected at most 1e+09");
}

TEST(Accessor, RefusesToUnpackMoreThanTheBudget) {
    tinygltf::Model zeros = four_floats();
    zeros.accessors[0].bufferView = -1;
    zeros.accessors[0].count = 1'000'000'000;

    EXPECT_EQ(
        refusal(zeros, 2), "its 1000000000 elements are more than a model of this size may unpack");
    EXPECT_EQ(
        refusal(four_floats(), 2, 15),
        "its 2 elements are more than a model of this size may unpack");
    EXPECT_EQ(refusal(four_floats(), 2, 16), "read");
}

TEST(Accessor, IntegersMustBeUnsignedAndPlain) {
    tinygltf::Model normalised = file_of<std::uint8_t>({1}, 5121, TINYGLTF_TYPE_SCALAR, 1);
    normalised.accessors[0].normalized = true;

    EXPECT_EQ(
        refusal_of_integers(
            file_of<std::uint32_t>({4'000'000'000U}, 5125, TINYGLTF_TYPE_SCALAR, 1)),
        "read");
    EXPECT_THAT(
        refusal_of_integers(file_of<float>({1}, 5126, TINYGLTF_TYPE_SCALAR, 1)),
        HasSubstr("component type 5126"));
    EXPECT_THAT(
        refusal_of_integers(file_of<std::int16_t>({1}, 5122, TINYGLTF_TYPE_SCALAR, 1)),
        HasSubstr("where unsigned integers are expected"));
    EXPECT_THAT(refusal_of_integers(normalised), HasSubstr("normalised"));
}

} // namespace
