#include "tests/support/pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include "tools/measure/edges.hpp"
#include "tools/measure/motion.hpp"

namespace measure {
namespace {

TEST(ChangedPx, CountsEachPixelOnceAndBitForBit) {
    std::vector<Mask> frames(16, Mask(4, 4, 0.5F));
    EXPECT_EQ(changed_px(frames).value(), 0.0);

    frames[3].at(1, 1) = 0.75F;
    frames[9].at(1, 1) = 0.25F;
    frames[9].at(2, 1) = std::nextafter(0.5F, 1.0F);
    EXPECT_EQ(changed_px(frames).value(), 2.0);
}

TEST(ChangedPx, NeedsTwoFrames) {
    EXPECT_FALSE(changed_px({}).known());
}

/// 64 x 64 picture, its tile at (32, 0) set to a visibility in both masks.
Comparison patch(float measured, float truth) {
    Comparison frame = comparison(Mask(64, 64), Mask(64, 64));
    for (int y = 0; y < 32; ++y)
        for (int x = 32; x < 64; ++x) {
            frame.measured.at(x, y) = measured;
            frame.truth.at(x, y) = truth;
        }
    return frame;
}

TEST(Pop, IsTheSwitchOfAPatchTimesItsContrast) {
    EXPECT_NEAR(pop(patch(1.0F, 1.0F), patch(0.25F, 1.0F)), 0.75, 1e-6);

    const std::vector<float> contrast = {1.0F, 0.2F, 1.0F, 1.0F};
    EXPECT_NEAR(pop(patch(1.0F, 1.0F), patch(0.25F, 1.0F), contrast), 0.15, 1e-6);
}

TEST(Pop, SubtractsWhatTheTruthChangesItself) {
    EXPECT_NEAR(pop(patch(1.0F, 1.0F), patch(0.0F, 0.25F)), 0.25, 1e-6);
    EXPECT_EQ(pop(patch(1.0F, 1.0F), patch(1.0F, 0.0F)), 0.0);
}

TEST(Pop, IgnoresPixelsThatAreNotValidInBothFrames) {
    Comparison after = patch(0.0F, 1.0F);
    after.kind.assign(after.kind.size(), PixelKind::mismatch);

    EXPECT_EQ(pop(patch(1.0F, 1.0F), after), 0.0);
}

Tracks two_points(std::vector<float> measured, std::vector<float> truth) {
    return {2, measured.size() / 2, 1.0, std::move(measured), std::move(truth)};
}

TEST(Flicker, CountsFlipsBeyondTheTruths) {
    // Point 0 flips three times where the truth flips once; point 1 stays where the truth flips.
    const Tracks tracks = two_points({0, 1, 1, 1, 0, 1, 1, 1}, {0, 1, 1, 0, 1, 1, 1, 1});

    EXPECT_NEAR(flicker(tracks, 100.0).value(), 2.0 / (3.0 * 100.0), 1e-12);
}

TEST(Flicker, OfTheTruthItselfIsZero) {
    const Tracks tracks = two_points({0, 1, 1, 0, 0, 1}, {0, 1, 1, 0, 0, 1});

    EXPECT_EQ(flicker(tracks, 100.0).value(), 0.0);
}

TEST(Flicker, OfTheTruthIsThatOfItsSecondGrid) {
    // The second grid flips point 0 twice more than the first, and point 1 as often as it.
    Tracks tracks = two_points({0, 1, 0, 1, 0, 1, 0, 1}, {0, 1, 0, 0, 0, 1, 0, 1});
    EXPECT_THAT(truth_flicker(tracks, 100.0).reason(), testing::HasSubstr("second grid"));

    tracks.second = {0, 1, 1, 1, 0, 0, 0, 0};

    EXPECT_NEAR(truth_flicker(tracks, 100.0).value(), 2.0 / (3.0 * 100.0), 1e-12);
}

TEST(Flicker, SaysWhyItIsNotKnown) {
    EXPECT_THAT(flicker({}, 100.0).reason(), testing::HasSubstr("two frames"));
    EXPECT_THAT(flicker({0, 3, 1.0, {}, {}}, 100.0).reason(), testing::HasSubstr("every frame"));
    EXPECT_THAT(
        flicker(two_points({0, 0, 0, 0}, {0, 0, 0, 0}), 5.0).reason(), testing::HasSubstr("32 px"));
}

struct Filter {
    std::string name;
    int taps;
    double flicker; ///< flips per px of edge and frame, in texels

    friend std::ostream& operator<<(std::ostream& out, const Filter& filter) {
        return out << filter.name;
    }
};

/// Every valid pixel is one point; the truth does not change.
Tracks valid_tracks(
    const std::vector<Mask>& frames, const Mask& truth, const std::vector<PixelKind>& kind) {
    Tracks tracks;
    tracks.frame_count = frames.size();
    for (const Mask& frame : frames)
        for (std::size_t i = 0; i < kind.size(); ++i) {
            if (kind[i] != PixelKind::valid) continue;
            tracks.measured.push_back(frame.visibility[i]);
            tracks.truth.push_back(truth.visibility[i]);
        }
    tracks.point_count = tracks.truth.size() / tracks.frame_count;
    return tracks;
}

class MapFlicker : public testing::TestWithParam<Filter> {};

TEST_P(MapFlicker, OfATexelGridThatFallsDifferentlyInEveryFrame) {
    constexpr int kSize = 64;
    constexpr double kTexel = 4.0;
    constexpr int kFrames = 5;
    engine::Random random(21);
    constexpr int kEdges = 60;
    const std::vector<PixelKind> kind = pictures::round_picture(kSize);
    double flips = 0.0;
    double edge_px = 0.0;
    for (int edge = 0; edge < kEdges; ++edge) {
        const pictures::StraightEdge truth = pictures::turned_edge(edge, kEdges, kSize, random);
        const Mask true_mask = pictures::draw(kSize, kSize, truth);
        pictures::Grid grid = pictures::random_grid(kTexel, random);
        std::vector<Mask> frames;
        for (int frame = 0; frame < kFrames; ++frame) {
            grid.origin = pictures::random_origin(kTexel, random);
            frames.push_back(
                pictures::draw(kSize, kSize, pictures::through_map(truth, grid, GetParam().taps)));
        }
        const double length = crofton_length(cracks(true_mask, kind).size());
        flips += flicker(valid_tracks(frames, true_mask, kind), length).value() * length;
        edge_px += length;
    }

    EXPECT_NEAR(flips / edge_px / kTexel, GetParam().flicker, 0.012);
}

INSTANTIATE_TEST_SUITE_P(
    Filters,
    MapFlicker,
    testing::Values(
        Filter{"Nearest", 0, 0.331}, Filter{"Bilinear", 1, 0.270}, Filter{"Pcf3x3", 3, 0.171}),
    [](const testing::TestParamInfo<Filter>& tested) { return tested.param.name; });

/// A camera over a floor at y = 0, looking level along -Z from 1.7 m; the sun's shadow edge lies at
/// x = edge.
struct Walk {
    static constexpr int kWidth = 160;
    static constexpr int kHeight = 120;
    static constexpr double kFocal = 80.0; ///< px
    static constexpr double kEyeHeight = 1.7;
    double z = 0.0;

    [[nodiscard]] glm::dvec3 project(const glm::dvec3& point) const {
        const double depth = z - point.z;
        return {
            0.5 * kWidth + kFocal * point.x / depth,
            0.5 * kHeight - kFocal * (point.y - kEyeHeight) / depth,
            depth};
    }
    /// Infinite depth above the horizon.
    [[nodiscard]] double depth(double y_px) const {
        const double below = y_px - 0.5 * kHeight;
        return below > 0.0 ? kEyeHeight * kFocal / below : std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] glm::dvec3 hit(double x_px, double y_px) const {
        const double far = depth(y_px);
        return {(x_px - 0.5 * kWidth) * far / kFocal, 0.0, z - far};
    }
    [[nodiscard]] Comparison frame(double edge_x) const {
        const auto floor = [&](pictures::Place p) {
            return p.y < 0.5 * kHeight || hit(p.x, p.y).x > edge_x ? 1.0 : 0.0;
        };
        const Mask truth = pictures::draw(kWidth, kHeight, floor);
        Comparison frame = comparison(truth, truth);
        for (std::size_t i = 0; i < truth.pixel_count() / 2; ++i)
            frame.kind[i] = PixelKind::empty;
        return frame;
    }
    [[nodiscard]] std::vector<float> depths() const {
        const Mask depth_mask =
            pictures::draw(kWidth, kHeight, [&](pictures::Place p) { return depth(p.y); });
        return depth_mask.visibility;
    }
    [[nodiscard]] std::vector<glm::dvec3> hits() const {
        std::vector<glm::dvec3> all;
        for (int y = kHeight / 2; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                all.push_back(hit(x + 0.5, y + 0.5));
        return all;
    }
    void record(MotionRecorder& recorder, Comparison comparison) const {
        recorder.add(std::move(comparison), depths(), [this](const glm::dvec3& point) {
            return project(point);
        });
    }
};

constexpr int kWalkFrames = 8;
constexpr double kStep = 1.4 / 60.0;

TrackPoints walk_points() {
    return choose_points(
        Walk{0.0}.hits(), Walk{-(kWalkFrames - 1) * kStep}.hits(), std::size_t{2000}, 1);
}

TEST(MotionRecorder, FollowsARecedingFloorAndFindsNoFlickerInTheTruth) {
    MotionRecorder recorder(walk_points());
    for (int k = 0; k < kWalkFrames; ++k) {
        const Walk walk = {-k * kStep};
        walk.record(recorder, walk.frame(0.1));
    }

    const MotionFigures figures = recorder.figures();

    EXPECT_EQ(figures.flicker_per_px.value(), 0.0);
    EXPECT_EQ(figures.pop.value(), 0.0);
    EXPECT_GT(figures.tracked_points.value(), 1400.0);
    EXPECT_GT(figures.mean_edge_px.value(), 32.0);
}

TEST(MotionRecorder, HoldsAMaskThatIsTheSecondGridToBeAsStillAsTheTruth) {
    // What a second grid sees at a pixel is what a mask with its edge half a pixel off would show.
    MotionRecorder recorder(walk_points());
    for (int k = 0; k < kWalkFrames; ++k) {
        const Walk walk = {-k * kStep};
        const auto sampled = [&](double right, double down) {
            return pictures::draw(Walk::kWidth, Walk::kHeight, [&](pictures::Place p) {
                const bool sky = p.y + down < 0.5 * Walk::kHeight;
                return sky || walk.hit(p.x + right, p.y + down).x > 0.1 ? 1.0 : 0.0;
            });
        };
        const Mask depth = pictures::draw(
            Walk::kWidth, Walk::kHeight, [&](pictures::Place p) { return walk.depth(p.y + 0.5); });
        Comparison frame = walk.frame(0.1);
        frame.measured = sampled(0.5, 0.0);
        recorder.add(
            std::move(frame),
            walk.depths(),
            [&](const glm::dvec3& point) { return walk.project(point); },
            SecondGrid{sampled(0.5, 0.5).visibility, depth.visibility});
    }

    const MotionFigures figures = recorder.figures();

    EXPECT_GT(figures.tracked_points.value(), 1300.0);
    EXPECT_GT(figures.truth_flicker_per_px.value(), 0.0);
    EXPECT_NEAR(figures.flicker_ratio.value(), 1.0, 0.5);
}

TEST(MotionRecorder, CountsAShadowThatFlipsInEveryFrame) {
    MotionRecorder recorder(walk_points());
    for (int k = 0; k < kWalkFrames; ++k) {
        const Walk walk = {-k * kStep};
        Comparison frame = walk.frame(0.1);
        frame.measured = Mask(Walk::kWidth, Walk::kHeight, k % 2 == 0 ? 1.0F : 0.0F);
        walk.record(recorder, std::move(frame));
    }

    const MotionFigures figures = recorder.figures();

    const double pixels = figures.tracked_points.value() * walk_points().pixels_per_point;
    const double flips = figures.flicker_per_px.value() * figures.mean_edge_px.value();
    EXPECT_NEAR(flips / pixels, 1.0, 0.02);
    EXPECT_NEAR(figures.pop.value(), 1.0, 0.1);
}

TEST(MotionRecorder, ReadsUndecidedPixelsButNoOtherUnusableOnes) {
    const auto tracked = [](PixelKind kind) {
        MotionRecorder recorder(walk_points());
        for (int k = 0; k < 2; ++k) {
            Comparison frame = Walk().frame(0.1);
            if (k == 1) frame.kind.assign(frame.kind.size(), kind);
            Walk().record(recorder, std::move(frame));
        }
        return recorder.figures().tracked_points.value();
    };

    EXPECT_GT(tracked(PixelKind::valid), 1900.0);
    EXPECT_EQ(tracked(PixelKind::undecided), tracked(PixelKind::valid));
    EXPECT_EQ(tracked(PixelKind::grazing), 0.0);
}

TEST(MotionRecorder, DropsPointsThatSomethingElseHides) {
    MotionRecorder recorder(walk_points());
    for (int k = 0; k < 3; ++k) {
        const Walk walk;
        std::vector<float> depths = walk.depths();
        if (k == 1)
            for (std::size_t i = 0; i < depths.size(); ++i)
                if (i % Walk::kWidth < Walk::kWidth / 2) depths[i] *= 0.9F;
        recorder.add(
            walk.frame(0.1), depths, [&](const glm::dvec3& point) { return walk.project(point); });
    }

    EXPECT_NEAR(recorder.figures().tracked_points.value(), 1000.0, 60.0);
}

TEST(MotionRecorder, MeasuresPopWithoutPoints) {
    MotionRecorder recorder;
    recorder.add(patch(1.0F, 1.0F));
    EXPECT_FALSE(recorder.figures().pop.known());
    recorder.add(patch(0.5F, 1.0F));
    recorder.add(patch(0.5F, 1.0F));

    EXPECT_NEAR(recorder.figures().pop.value(), 0.5, 1e-6);
    EXPECT_THAT(recorder.figures().flicker_per_px.reason(), testing::HasSubstr("points"));
}

TEST(MotionRecorder, MeasuresCrawlOnlyWhereTheCameraStands) {
    const auto crawl = [](bool camera_stands) {
        MotionRecorder recorder({}, camera_stands);
        for (const double offset : {0.0, 2.0, 0.0})
            recorder.add(comparison(
                pictures::draw(48, 48, pictures::upright_edge(20.0 + offset)),
                pictures::draw(48, 48, pictures::upright_edge(20.0))));
        return recorder.figures().crawl_px;
    };

    EXPECT_NEAR(crawl(true).value(), 2.0 * 4.0 / std::numbers::pi, 1e-9);
    EXPECT_EQ(crawl(false).reason(), "the camera moves");
}

TEST(MotionRecorder, MeasuresLagWhereThereIsATwin) {
    const Comparison now = comparison(
        pictures::draw(48, 48, pictures::upright_edge(17.0)),
        pictures::draw(48, 48, pictures::upright_edge(20.0)));
    const Comparison redrawn = comparison(now.truth, now.truth);
    MotionRecorder recorder;
    EXPECT_FALSE(recorder.figures().lag.stale_p95_px.known());
    for (int frame = 0; frame < 3; ++frame) {
        recorder.add(now);
        recorder.add_lag(now, redrawn, std::array<int, 1>{frame});
    }

    const LagFigures lag = recorder.figures().lag;
    EXPECT_EQ(lag.stale_p95_px.value(), 3.0);
    EXPECT_EQ(lag.age_max.value(), 2.0);
}

TEST(ChoosePoints, StandForAllPixels) {
    const std::vector<glm::dvec3> hits(900, glm::dvec3(1.0));

    const TrackPoints chosen = choose_points(hits, hits, 100, 1);
    EXPECT_EQ(chosen.points.size(), 100U);
    EXPECT_NEAR(chosen.pixels_per_point, 9.0, 1e-12);

    const TrackPoints all = choose_points(hits, hits, 5000, 1);
    EXPECT_EQ(all.points.size(), 1800U);
    EXPECT_NEAR(all.pixels_per_point, 0.5, 1e-12);

    EXPECT_TRUE(choose_points({}, {}, 10, 1).points.empty());
}

} // namespace
} // namespace measure
