// Every case of the atlas, twice: the naive method must fail, or the test could not; the remedy
// must hold all the way through the sweep.

#include "tests/atlas/cases.hpp"
#include "tests/atlas/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tools/gnomon/studio.hpp"

namespace atlas {
namespace {

bool has_opengl() {
    static const bool has = gnomon::Studio::open(kPictureSize, kPictureSize).has_value();
    return has;
}

class Atlas : public testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
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
    for (const double step : steps_of(one.sweep, 5)) {
        SCOPED_TRACE(step);
        Stage stage = one.build(step);

        const auto seen = observe(
            stage, {}, step == one.sweep.worst ? one.id : fmt::format("{}_at_{:g}", one.id, step));

        ASSERT_TRUE(seen) << engine::to_string(seen.error());
        EXPECT_GT(seen->figures.valid_px, 1000.0) << "a picture with nothing to compare";
        EXPECT_THAT(broken_gates(one, *seen), testing::IsEmpty()) << one.sentence;
    }
}

class AtlasRefusal : public testing::TestWithParam<Refusal> {
protected:
    void SetUp() override {
        if (!has_opengl()) GTEST_SKIP() << "no OpenGL here";
    }
};

TEST_P(AtlasRefusal, IsSaidWithItsReason) {
    const Refusal& one = GetParam();
    Stage stage = one.build();

    const auto seen = observe(stage, {}, one.id + "_" + one.technique);

    ASSERT_FALSE(seen) << one.technique << " drew it: " << one.sentence;
    EXPECT_THAT(
        seen.error().message,
        testing::HasSubstr(one.technique + ": outside its domain: " + one.reason));
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

INSTANTIATE_TEST_SUITE_P(
    Cases,
    AtlasRefusal,
    testing::ValuesIn(refusals()),
    [](const testing::TestParamInfo<Refusal>& one) {
        return one.param.id + "_" + one.param.technique;
    });

TEST(AtlasLists, NoFailureBothOccursAndCannot) {
    std::set<std::string> occurring;
    for (const Case& one : all_cases())
        EXPECT_TRUE(occurring.insert(one.id).second) << one.id << " is there twice";
    for (const Impossible& one : impossible())
        EXPECT_TRUE(occurring.insert(one.id).second) << one.id << " occurs, too";
}

} // namespace
} // namespace atlas
