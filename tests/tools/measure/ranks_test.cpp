#include <gtest/gtest.h>

#include "tools/measure/ranks.hpp"

namespace measure {
namespace {

TEST(Ranks, AreTheNearest) {
    const std::vector<float> values = {5.0F, 1.0F, 4.0F, 2.0F, 3.0F};

    EXPECT_EQ(percentile(values, 0.0), 1.0);
    EXPECT_EQ(percentile(values, 0.2), 1.0);
    EXPECT_EQ(percentile(values, 0.21), 2.0);
    EXPECT_EQ(percentile(values, 0.99), 5.0);
    EXPECT_EQ(percentile(values, 1.0), 5.0);
    EXPECT_EQ(mean(values), 3.0);
}

} // namespace
} // namespace measure
