#include "metrics/analysis/analysis.h"

#include "metrics/analysis/distance.h"
#include "metrics/evaluate.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

namespace aoscore {
namespace {

using testing::mask_out;
using testing::natural_pair;
using testing::Pair;

TEST(OcclusionMasks, NeedThreeStandardErrorsOfTheTruth) {
    Pair pair(4, 1);
    pair.truth.pixels = {0.5F, 0.5F, 0.5F, 0.5F};
    pair.test.pixels = {0.75F, 0.75F, 0.25F, 0.25F};
    ImageF standard_error(4, 1);
    standard_error.pixels = {0.08F, 0.09F, 0.08F, 0.09F};
    const OcclusionMasks masks = occlusion_masks(pair.input(&standard_error));
    EXPECT_EQ(masks.missing.pixels, (std::vector<std::uint8_t>{1, 0, 0, 0}));
    EXPECT_EQ(masks.false_occlusion.pixels, (std::vector<std::uint8_t>{0, 0, 1, 0}));
}

TEST(MaskSummary, DividesPixelsAmongTheirCausesInProportion) {
    Pair pair(4, 1);
    pair.truth.pixels = {0, 0.5F, 0.5F, 0};
    pair.test.pixels = {0.75F, 1, 0.5F, 1};
    pair.valid.pixels = {1, 1, 1, 0};
    ImageF outside(4, 1), hidden(4, 1);
    outside.pixels = {0.25F, 0.5F, 0.5F, 0};
    hidden.pixels = {0.75F, 0, 0, 1};
    const MaskSummary summary = measure_mask(pair.input(), MaskSide::missing, kMaskThreshold,
                                             {{"outside", &outside}, {"hidden", &hidden}})
                                    .summary;
    EXPECT_DOUBLE_EQ(summary.area, 2.0 / 3);
    EXPECT_DOUBLE_EQ(*summary.mean, 0.625);
    ASSERT_EQ(summary.causes.size(), 2U);
    EXPECT_EQ(summary.causes[0].cause, "outside");
    EXPECT_DOUBLE_EQ(summary.causes[0].area, 1.25 / 3);
    EXPECT_DOUBLE_EQ(*summary.causes[0].mean, (0.25 * 0.75 + 0.5) / 1.25);
    EXPECT_DOUBLE_EQ(summary.causes[1].area, 0.75 / 3);
    EXPECT_DOUBLE_EQ(*summary.causes[1].mean, 0.75);
}

TEST(WorstRegions, AreConnectedPiecesWithPlaceSizeAndCauseWorstFirst) {
    Pair pair(40, 30);
    pair.truth = ImageF(40, 30, 0.5F);
    pair.test = pair.truth;
    for (int i = 0; i < 6; ++i) pair.test.at(10 + i, 5 + i) = 0.75F;  // These pixels touch at corners only.
    pair.test.at(12, 7) = 1.0F;
    pair.test.at(30, 20) = 0.8F;
    for (int x = 3; x < 6; ++x) pair.test.at(x, 25) = 0.25F;
    ImageF outside(40, 30, 0.1F), hidden(40, 30, 0.4F);
    const PixelFacts facts{{}, {}, {}, {}, {{"outside", &outside}, {"hidden", &hidden}}};
    const auto regions = worst_regions(occlusion_masks(pair.input()), pair.input(), facts.causes);
    ASSERT_EQ(regions.size(), 3U);
    const ErrorRegion& worst = regions[0];
    EXPECT_EQ(worst.kind, "missing");
    EXPECT_EQ(std::tie(worst.left, worst.top, worst.width, worst.height), std::make_tuple(10, 5, 6, 6));
    EXPECT_EQ(std::tie(worst.worst_x, worst.worst_y), std::make_tuple(12, 7));
    EXPECT_DOUBLE_EQ(worst.worst_error, 0.5);
    EXPECT_EQ(worst.area_px, 6U);
    EXPECT_NEAR(worst.mean_error, 1.75 / 6, 1e-7);
    EXPECT_EQ(worst.cause, "hidden");
    EXPECT_EQ(regions[1].area_px, 1U);
    EXPECT_EQ(regions[2].kind, "false");
    EXPECT_DOUBLE_EQ(regions[2].mean_error, -0.25);
}

TEST(WorstRegions, ListsNoMoreThanItSays) {
    Pair pair(64, 64);
    for (int y = 0; y < 64; y += 2) {
        for (int x = 0; x < 64; x += 2) pair.test.at(x, y) = 0.2F + static_cast<float>(x + y) / 500.0F;
    }
    const auto regions = worst_regions(occlusion_masks(pair.input()), pair.input(), {});
    ASSERT_EQ(regions.size(), kListedRegions);
    EXPECT_EQ(regions[0].left, 62);
    EXPECT_EQ(regions[0].top, 62);
    EXPECT_EQ(regions[0].cause, "");
}

/// The pieces of the pixels that are brighter by more than a threshold, each filled from its first pixel.
std::vector<ErrorRegion> flooded(const Pair& pair, double threshold) {
    Mask left = pair.valid;
    const auto error = [&](int x, int y) { return double{pair.test.at(x, y)} - double{pair.truth.at(x, y)}; };
    std::vector<ErrorRegion> pieces;
    for (int y = 0; y < left.height; ++y) {
        for (int x = 0; x < left.width; ++x) {
            std::vector<std::pair<int, int>> open{{x, y}};
            ErrorRegion piece;
            int right = x, bottom = y;
            piece.left = x;
            piece.top = y;
            while (!open.empty()) {
                const auto [px, py] = open.back();
                open.pop_back();
                if (px < 0 || py < 0 || px >= left.width || py >= left.height) continue;
                if (left.at(px, py) == 0 || error(px, py) <= threshold) continue;
                left.at(px, py) = 0;
                ++piece.area_px;
                piece.mean_error += error(px, py);
                piece.worst_error = std::max(piece.worst_error, error(px, py));
                piece.left = std::min(piece.left, px);
                piece.top = std::min(piece.top, py);
                right = std::max(right, px);
                bottom = std::max(bottom, py);
                for (int i = 0; i < 9; ++i) open.emplace_back(px + i % 3 - 1, py + i / 3 - 1);
            }
            if (piece.area_px == 0) continue;
            piece.width = right - piece.left + 1;
            piece.height = bottom - piece.top + 1;
            piece.mean_error /= static_cast<double>(piece.area_px);
            pieces.push_back(piece);
        }
    }
    std::ranges::stable_sort(pieces, std::ranges::greater(), [](const ErrorRegion& piece) {
        return piece.mean_error * static_cast<double>(piece.area_px);
    });
    return pieces;
}

TEST(WorstRegions, AreThePiecesThatAFloodFillsWhateverTheirShape) {
    for (const double share : {0.1, 0.3, 0.4, 0.5, 0.7, 0.95}) {
        Pair pair = natural_pair(57, 43);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> error(0.1F, 0.4F);
        std::bernoulli_distribution marked(share);
        for (std::size_t i = 0; i < pair.test.size(); ++i)
            pair.test.pixels[i] = pair.truth.pixels[i] + (marked(random) ? error(random) : 0.0F);
        mask_out(pair, 0.9);
        const std::vector<ErrorRegion> expected = flooded(pair, 0.1);
        const auto found = worst_regions(occlusion_masks(pair.input(), 0.1), pair.input(), {});
        ASSERT_EQ(found.size(), std::min(expected.size(), kListedRegions)) << share;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const ErrorRegion &a = found[i], &b = expected[i];
            EXPECT_EQ(std::tie(a.left, a.top, a.width, a.height, a.area_px),
                      std::tie(b.left, b.top, b.width, b.height, b.area_px))
                << share << ", " << i;
            EXPECT_NEAR(a.mean_error, b.mean_error, 1e-12);
            EXPECT_EQ(a.worst_error, b.worst_error);
            EXPECT_EQ(
                double{pair.test.at(a.worst_x, a.worst_y)} - double{pair.truth.at(a.worst_x, a.worst_y)},
                b.worst_error);
        }
    }
}

TEST(BestFit, FindsTheStrengthAndExponentThatWereTakenOff) {
    for (const double strength : {0.6, 1.0, 1.5}) {
        for (const double exponent : {0.5, 1.0, 2.5}) {
            Pair pair(96, 96);
            for (std::size_t i = 0; i < pair.truth.size(); ++i) {
                const double truth =
                    0.75 + 0.25 * static_cast<double>(i) / static_cast<double>(pair.truth.size());
                pair.truth.pixels[i] = static_cast<float>(truth);
                pair.test.pixels[i] = static_cast<float>(1 - (1 - std::pow(truth, 1 / exponent)) / strength);
            }
            const auto fit = best_fit(pair.input());
            ASSERT_TRUE(fit);
            EXPECT_NEAR(fit->strength, strength, 0.03 * strength);
            EXPECT_NEAR(fit->exponent, exponent, 0.03 * exponent);
            EXPECT_LT(fit->rmse, 2e-4);
        }
    }
}

TEST(BestFit, IsNeverWorseThanTheImageAsItIs) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Pair pair = natural_pair(64, 64, seed);
        for (float& value : pair.test.pixels) value = std::clamp(value, 0.0F, 1.0F);
        mask_out(pair, 0.7, seed);
        const ImageF standard_error(64, 64, 0.01F);
        const MetricInput input = pair.input(&standard_error);
        const auto fit = best_fit(input);
        ASSERT_TRUE(fit);
        EXPECT_LE(fit->rmse, *metric("rmse").measure(input).value + 1e-7);
        ASSERT_TRUE(fit->rmse_debiased);
        EXPECT_LE(*fit->rmse_debiased, *metric("rmse_debiased").measure(input).value + 1e-7);
    }
}

PixelFacts all_facts(const Pair& pair, const ImageF& occlusion, const ImageF& other) {
    PixelFacts facts;
    facts.depth_m = facts.tilt = facts.edge_distance_px = ImageF(pair.truth.width, pair.truth.height);
    for (std::size_t i = 0; i < pair.truth.size(); ++i) {
        facts.depth_m.pixels[i] = 1.0F + static_cast<float>(i % 97);
        facts.tilt.pixels[i] = static_cast<float>(i % 101) / 100.0F;
        facts.edge_distance_px.pixels[i] = static_cast<float>(i % 53);
    }
    facts.causes = {{"outside", &occlusion}, {"visible", &other}};
    return facts;
}

TEST(Splits, SharesAddUpToOneAndTheirErrorsToTheWhole) {
    Pair pair = natural_pair(200, 160);
    mask_out(pair, 0.6);
    const ImageF standard_error(200, 160, 0.01F);
    const MetricInput input = pair.input(&standard_error);
    ImageF outside = pair.truth, visible(200, 160, 0.25F);
    for (std::size_t i = 0; i < outside.size(); i += 3) outside.pixels[i] = visible.pixels[i] = 0;
    const std::vector<Split> splits = error_splits(input, all_facts(pair, outside, visible));
    EXPECT_EQ(splits.size(), 6U);
    const double rmse = *metric("rmse").measure(input).value, bias = *metric("bias").measure(input).value;
    for (const Split& split : splits) {
        double share = 0, error_share = 0, squared = 0, signed_sum = 0;
        for (const SplitBin& bin : split.bins) {
            share += bin.share;
            error_share += bin.error_share;
            EXPECT_EQ(bin.rmse.has_value(), bin.share > 0) << split.id << " " << bin.label;
            squared += bin.share * std::pow(bin.rmse.value_or(0), 2);
            signed_sum += bin.share * bin.bias.value_or(0);
            EXPECT_NEAR(bin.noise_rmse.value_or(0.01), 0.01, 1e-6);
        }
        EXPECT_NEAR(share, 1, 1e-12) << split.id;
        EXPECT_NEAR(error_share, 1, 1e-12) << split.id;
        EXPECT_NEAR(std::sqrt(squared), rmse, 1e-12) << split.id;
        EXPECT_NEAR(signed_sum, bias, 1e-12) << split.id;
        EXPECT_GE(split.bins.size(), 2U) << split.id;
        EXPECT_FALSE(split.meaning.empty()) << split.id;
    }
}

TEST(Splits, LeaveOutWhatIsNotKnown) {
    const Pair pair = natural_pair(64, 64);
    std::vector<std::string> ids;
    for (const Split& split : error_splits(pair.input(), {})) ids.push_back(split.id);
    EXPECT_EQ(ids, (std::vector<std::string>{"sign", "border_distance"}));
}

TEST(Splits, PutErrorsBesideAnEdgeWhereTheyBelong) {
    Pair pair(128, 64);
    Mask edges(128, 64);
    for (int y = 0; y < 64; ++y) edges.at(40, y) = 1;
    PixelFacts facts;
    facts.edge_distance_px = distance_to(edges);
    for (int y = 0; y < 64; ++y) pair.test.at(45, y) = 0.5F;
    for (const Split& split : error_splits(pair.input(), facts)) {
        if (split.id != "edge_distance") continue;
        ASSERT_EQ(split.bins[2].label, "4 to 8");
        EXPECT_DOUBLE_EQ(split.bins[2].error_share, 1);
        EXPECT_NEAR(split.bins[2].share, 8.0 / 128, 1e-12);
        EXPECT_DOUBLE_EQ(*split.bins[2].bias, 0.5 / 8);
    }
}

TEST(Splits, TellTheFarSideOfAnEdgeFromTheNearOne) {
    Pair pair(128, 64);
    Mask near(128, 64), far(128, 64);
    for (int y = 0; y < 64; ++y) near.at(40, y) = far.at(41, y) = 1;
    PixelFacts facts;
    facts.behind_edge_px = distance_to(far);
    facts.edge_distance_px = distance_to(near);
    for (std::size_t i = 0; i < near.size(); ++i)
        facts.edge_distance_px.pixels[i] =
            std::min(facts.edge_distance_px.pixels[i], facts.behind_edge_px.pixels[i]);
    for (int y = 0; y < 64; ++y) pair.test.at(43, y) -= 0.5F;
    const std::vector<Split> splits = error_splits(pair.input(), facts);
    const auto split = std::ranges::find(splits, "edge_side", &Split::id);
    ASSERT_NE(split, splits.end());
    ASSERT_EQ(split->bins[0].label, "far side");
    EXPECT_DOUBLE_EQ(split->bins[0].error_share, 1);
    EXPECT_DOUBLE_EQ(split->bins[0].share, 8.0 / 128) << "the eight pixels behind it";
    EXPECT_DOUBLE_EQ(split->bins[1].share, 8.0 / 128) << "and the eight before it";
    EXPECT_DOUBLE_EQ(*split->bins[0].bias, -0.5 / 8);
    const BinBlocks behind = analyse(pair.input(), facts, 0.1, 1).value().behind_edges;
    EXPECT_DOUBLE_EQ(std::accumulate(behind.counts.begin(), behind.counts.end(), 0.0), 8 * 64);
    EXPECT_DOUBLE_EQ(std::accumulate(behind.signed_sums.begin(), behind.signed_sums.end(), 0.0), -0.5 * 64);
    const auto rows = std::ranges::count_if(behind.signed_sums, [](double sum) { return sum != 0; });
    EXPECT_EQ(rows, (64 + 4) / 5) << "blocks of five pixels a side, one above the other";
}

TEST(DistanceTo, IsTheDistanceFromTheNearestMarkedPixel) {
    std::mt19937 random(3);
    Mask marked(37, 23);
    for (int i = 0; i < 9; ++i) marked.pixels[random() % marked.size()] = 1;
    const ImageF distance = distance_to(marked);
    for (int y = 0; y < marked.height; ++y) {
        for (int x = 0; x < marked.width; ++x) {
            double least = std::numeric_limits<double>::infinity();
            for (int my = 0; my < marked.height; ++my) {
                for (int mx = 0; mx < marked.width; ++mx) {
                    if (marked.at(mx, my) != 0) least = std::min(least, std::hypot(mx - x, my - y));
                }
            }
            ASSERT_NEAR(distance.at(x, y), least, 1e-5) << x << ", " << y;
        }
    }
    EXPECT_TRUE(std::isinf(distance_to(Mask(5, 4)).at(2, 2)));
}

TEST(ErrorDistribution, CountsSignedErrorsInBinsAndAbsoluteOnesCumulatively) {
    Pair pair(5, 1);
    pair.truth.pixels = {0.5F, 0.5F, 0.5F, 1, 0};
    pair.test.pixels = {0.5F, 0.75F, 0.25F, -7, 1};
    pair.valid.pixels = {1, 1, 1, 1, 0};
    const ErrorDistribution d = error_distribution(pair.input());
    ASSERT_EQ(d.histogram.size(), 201U);
    ASSERT_EQ(d.cumulative.size(), 201U);
    EXPECT_DOUBLE_EQ(d.histogram[100], 0.25);
    EXPECT_DOUBLE_EQ(d.histogram[125], 0.25);
    EXPECT_DOUBLE_EQ(d.histogram[75], 0.25);
    EXPECT_DOUBLE_EQ(d.histogram[0], 0.25);
    EXPECT_DOUBLE_EQ(d.cumulative[0], 0.25);
    EXPECT_DOUBLE_EQ(d.cumulative[49], 0.25);
    EXPECT_DOUBLE_EQ(d.cumulative[50], 0.75);
    EXPECT_DOUBLE_EQ(d.cumulative[200], 0.75) << "an error of 8 is beyond all steps";
}

TEST(Analysis, IsEmptyWhereNothingIsValidOrAValidPixelIsNan) {
    Pair pair = natural_pair(48, 48);
    EXPECT_TRUE(analyse(pair.input(), {}, kMaskThreshold, 1));
    pair.test.at(3, 3) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(analyse(pair.input(), {}, kMaskThreshold, 1));
    pair.valid = Mask(48, 48, 0);
    EXPECT_FALSE(analyse(pair.input(), {}, kMaskThreshold, 1));
}

}  // namespace
}  // namespace aoscore
