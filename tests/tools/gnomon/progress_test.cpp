#include <gtest/gtest.h>

#include "tools/gnomon/progress.hpp"

namespace gnomon {
namespace {

TEST(Progress, TellsHowMuchIsDoneAndHowLongTheRestTakes) {
    EXPECT_EQ(progress_line("walk 3/4", 3.0, 4.0, 30.0), "walk 3/4, 75 %, 10 s left");
    EXPECT_EQ(progress_line("x", 1.0, 14.0, 10.0), "x, 7 %, 2 min 10 s left");
    EXPECT_EQ(progress_line("x", 1.0, 1201.0, 10.0), "x, 0 %, 3 h 20 min left");
    EXPECT_EQ(progress_line("x", 4.0, 4.0, 30.0), "x, 100 %, 0 s left");
}

TEST(Progress, PromisesNothingBeforeAnythingIsDone) {
    EXPECT_EQ(progress_line("truth", 0.0, 4.0, 30.0), "truth");
}

TEST(Progress, NeverEndsBeforeTheEndWhenMoreWasDoneThanExpected) {
    EXPECT_EQ(progress_line("x", 5.0, 4.0, 30.0), "x, 100 %, 0 s left");
}

TEST(Progress, TakesPartsThatAreToComeForAsLongAsTheOthers) {
    Progress progress(4);
    EXPECT_EQ(progress.total(), 0.0);
    progress.begin_part(10.0);
    EXPECT_EQ(progress.total(), 40.0);
    progress.begin_part(30.0);
    EXPECT_EQ(progress.total(), 80.0);
    progress.begin_part(0.0);
    progress.begin_part(8.0);
    progress.add(3.0);

    EXPECT_EQ(progress.total(), 48.0);
    EXPECT_EQ(progress.done(), 3.0);
}

} // namespace
} // namespace gnomon
