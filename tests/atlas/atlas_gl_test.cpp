// Every case of the atlas, twice: the naive method must fail, or the test could not; the remedy
// must hold all the way through the sweep.

#include "tests/atlas/cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tools/gnomon/studio.hpp"

namespace atlas {
namespace {

/// With the worst step in the place of the nearest one.
std::vector<double> five_steps(const Sweep& sweep) {
    std::vector<double> steps;
    for (int i = 0; i < 5; ++i)
        steps.push_back(sweep.from + (sweep.to - sweep.from) * i / 4.0);
    *std::min_element(steps.begin(), steps.end(), [&](double a, double b) {
        return std::abs(a - sweep.worst) < std::abs(b - sweep.worst);
    }) = sweep.worst;
    return steps;
}

class Atlas : public testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        static const bool has_opengl = gnomon::Studio::open(kPictureSize, kPictureSize).has_value();
        if (!has_opengl) GTEST_SKIP() << "no OpenGL here";
    }
};

using AtlasWithout = Atlas;

TEST_P(AtlasWithout, TheNaiveMethodFails) {
    const Case& one = GetParam();
    Stage stage = one.build(one.sweep.worst);

    const auto seen = observe(stage, shadows::Remedies().without(*one.remedy), one.id + "_without");

    ASSERT_TRUE(seen) << engine::to_string(seen.error());
    EXPECT_THAT(broken_gates(one, *seen), testing::Not(testing::IsEmpty())) << one.sentence;
}

TEST_P(Atlas, TheRemedyHolds) {
    const Case& one = GetParam();
    for (const double step : five_steps(one.sweep)) {
        SCOPED_TRACE(step);
        Stage stage = one.build(step);

        const auto seen = observe(
            stage, {}, step == one.sweep.worst ? one.id : fmt::format("{}_at_{:g}", one.id, step));

        ASSERT_TRUE(seen) << engine::to_string(seen.error());
        EXPECT_GT(seen->figures.valid_px, 1000.0) << "a picture with nothing to compare";
        EXPECT_THAT(broken_gates(one, *seen), testing::IsEmpty()) << one.sentence;
    }
}

/// Where nothing can be turned off, nothing has to fail.
std::vector<Case> cases_with_remedies() {
    std::vector<Case> cases = all_cases();
    std::erase_if(cases, [](const Case& one) { return !one.remedy; });
    return cases;
}

std::string id_of(const testing::TestParamInfo<Case>& one) {
    return one.param.id;
}

INSTANTIATE_TEST_SUITE_P(Cases, Atlas, testing::ValuesIn(all_cases()), id_of);
INSTANTIATE_TEST_SUITE_P(Cases, AtlasWithout, testing::ValuesIn(cases_with_remedies()), id_of);

} // namespace
} // namespace atlas
