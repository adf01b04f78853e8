// Every technique keeps what it promises on the committed scenes.

#include "tests/gates/gates.hpp"

#include <gtest/gtest.h>

#include "tools/gnomon/studio.hpp"

namespace gates {
namespace {

class Gates : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        if (!gnomon::Studio::open(16, 16)) GTEST_SKIP() << "no OpenGL here";
    }
};

TEST_P(Gates, HoldOnTheScene) {
    std::vector<Promise> promised;
    for (const Promise& one : promises())
        if (one.scene == GetParam()) promised.push_back(one);
    const auto rows = measure_promises(promised);
    ASSERT_TRUE(rows) << engine::to_string(rows.error());

    for (const Promise& one : promised)
        for (const Broken& broken : broken_gates(one, *rows))
            ADD_FAILURE() << broken.sentence;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Gates, testing::ValuesIn(scenes()), [](const testing::TestParamInfo<std::string>& one) {
        return one.param;
    });

} // namespace
} // namespace gates
