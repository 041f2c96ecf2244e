#include "metrics/intervals/bootstrap.h"

#include "core/error.h"
#include "metrics/analysis/mask_summary.h"
#include "metrics/analysis/mask_totals.h"
#include "metrics/analysis/occlusion_masks.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/intervals/ratio_interval.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>

namespace aoscore {
namespace {

using testing::natural_pair;
using testing::Pair;

/// Blocks of one pixel each with these squared errors.
BlockErrors blocks_of(const std::vector<double>& squared_errors) {
    BlockErrors blocks;
    blocks.side_px = 1;
    blocks.across = static_cast<int>(squared_errors.size());
    blocks.down = 1;
    blocks.counts.assign(squared_errors.size(), 1);
    blocks.squared_sums = squared_errors;
    for (const double squared : squared_errors) {
        blocks.absolute_sums.push_back(std::sqrt(squared));
        blocks.signed_sums.push_back(std::sqrt(squared));
    }
    return blocks;
}

std::vector<double> values(const std::string& metric, const BlockErrors& blocks, std::uint64_t seed = 1) {
    const std::array<const BlockErrors*, 1> images{&blocks};
    return resampled(metric, images, seed);
}

TEST(BlockErrors, AddUpToTheImage) {
    Pair pair = natural_pair(130, 70);
    testing::mask_out(pair, 0.7);
    const ImageF standard_error(130, 70, 0.5F);
    const BlockErrors blocks = block_errors(pair.input(&standard_error));
    EXPECT_EQ(blocks.side_px, 5);
    ASSERT_EQ(blocks.counts.size(), static_cast<std::size_t>(blocks.across * blocks.down));
    double count = 0, squared = 0, variance = 0;
    for (std::size_t i = 0; i < blocks.counts.size(); ++i) {
        count += blocks.counts[i];
        squared += blocks.squared_sums[i];
        variance += blocks.variance_sums[i];
    }
    EXPECT_EQ(count, std::count(pair.valid.pixels.begin(), pair.valid.pixels.end(), 1));
    EXPECT_NEAR(std::sqrt(squared / count), *metrics().front().measure(pair.input()).value, 1e-12);
    EXPECT_DOUBLE_EQ(variance, 0.25 * count);
}

TEST(Bootstrap, IntervalHoldsTheTrueValueAboutAsOftenAsItSays) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    int held = 0;
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        std::vector<double> squared;
        for (int i = 0; i < 120; ++i) squared.push_back(std::pow(normal(random), 2));
        const auto interval = confidence_interval(values("rmse", blocks_of(squared), trial));
        ASSERT_TRUE(interval);
        held += interval->low <= 1 && 1 <= interval->high;
    }
    // 95 % of 200 is 190 with a standard deviation of 3.1; a percentile interval of 120 heavy-tailed values
    // holds a little less.
    EXPECT_GE(held, 175);
    EXPECT_LT(held, 200);
}

TEST(Bootstrap, DifferencesArePairedSoThatWhatTwoTestsShareCancels) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    int held = 0;
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        std::vector<double> a, b;
        for (int i = 0; i < 120; ++i) {
            const double common = 10 * std::abs(normal(random));
            a.push_back(common + 1 + 0.2 * normal(random));
            b.push_back(common + 1.2 + 0.2 * normal(random));
            a.back() = std::pow(a.back(), 2);
            b.back() = std::pow(b.back(), 2);
        }
        const auto of_a = values("mae", blocks_of(a), trial), of_b = values("mae", blocks_of(b), trial);
        const auto paired = confidence_interval(of_a, of_b), alone = confidence_interval(of_a);
        ASSERT_TRUE(paired && alone);
        EXPECT_LT(paired->high - paired->low, 0.1 * (alone->high - alone->low));
        held += paired->low <= -0.2 && -0.2 <= paired->high;
    }
    EXPECT_GE(held, 177);
    EXPECT_LE(held, 200);
}

/// The measurements of a pair: values by id of bootstrap_measures(), and the sums that they are resampled
/// from.
struct Measured {
    std::map<std::string, double> values;
    BlockErrors blocks;
};

Measured measured(const Pair& pair) {
    const ImageF standard_error(pair.truth.width, pair.truth.height, 0.01F);
    MapSums maps;
    MetricInput input = pair.input(&standard_error);
    input.maps = &maps;
    Measured result;
    for (const auto& [id, metric] : evaluate(input)) result.values[id] = metric.value.value();
    result.values[kMissingArea] = measure_mask(input, MaskSide::missing, kMaskThreshold).summary.area;
    result.values[kFalseArea] = measure_mask(input, MaskSide::false_occlusion, kMaskThreshold).summary.area;
    result.blocks = with_masks(block_errors(input), mask_totals(input, kMaskThreshold));
    return result;
}

std::map<std::string, Interval> intervals_of(const BlockErrors& blocks) {
    const std::array<const BlockErrors*, 1> images{&blocks};
    return confidence_intervals(images, 1);
}

double total(const std::vector<double>& sums) {
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// A picture whose only errors are patches, each with its own error.
Pair patchwork(int side_px, int patch_px, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> shift(-0.3F, 0.3F), noise(-2, 2), texture(-0.1F, 0.1F);
    const int across = (side_px + patch_px - 1) / patch_px;
    Image<float> shifts(across, across), noises(across, across);
    for (float& value : shifts.pixels) value = shift(random);
    for (float& value : noises.pixels) value = noise(random);
    Pair pair(side_px, side_px);
    for (int y = 0; y < side_px; ++y) {
        for (int x = 0; x < side_px; ++x) {
            const int px = x / patch_px, py = y / patch_px;
            pair.truth.at(x, y) = 0.5F + texture(random);
            pair.test.at(x, y) =
                pair.truth.at(x, y) + shifts.at(px, py) + noises.at(px, py) * texture(random);
        }
    }
    return pair;
}

TEST(BlockErrors, OfMapsAddUpToTheirMetrics) {
    Pair pair = natural_pair(250, 190);
    testing::mask_out(pair, 0.9);
    const Measured all = measured(pair);
    const BlockErrors& blocks = all.blocks;
    EXPECT_NEAR(total(blocks.maps.ssim_sums) / total(blocks.maps.ssim_weights), all.values.at("ssim"), 1e-12);
    EXPECT_NEAR(total(blocks.maps.flip_sums) / total(blocks.counts), all.values.at("flip"), 1e-12);
    for (const char* area : {kMissingArea, kFalseArea})
        EXPECT_NEAR(value_of_blocks(area, blocks), all.values.at(area), 1e-12) << area;
}

TEST(BlockErrors, InfluenceOfASquareIsWhatMsSsimLosesWithoutIt) {
    const auto ms_ssim_of = [](const Pair& pair, MapSums& maps) {
        MetricInput input = pair.input();
        input.maps = &maps;
        return *metric("ms_ssim").measure(input).value;
    };
    Pair pair = patchwork(5 * 176, 40, 1);
    MapSums whole, part;
    const double value = ms_ssim_of(pair, whole);
    ASSERT_EQ(whole.ms_ssim_influences.size(), 25U);
    EXPECT_NEAR(total(whole.ms_ssim_influences), 0, 1e-12);
    // Takes the square with the largest effect, of which its neighbours' windows miss the least.
    const auto most =
        std::ranges::max_element(whole.ms_ssim_influences, {}, [](double x) { return std::abs(x); });
    const auto square = static_cast<int>(most - whole.ms_ssim_influences.begin());
    for (int y = 0; y < 176; ++y) {
        for (int x = 0; x < 176; ++x) pair.valid.at(square % 5 * 176 + x, square / 5 * 176 + y) = 0;
    }
    const double lost = std::log(value / ms_ssim_of(pair, part));
    EXPECT_GT(std::abs(lost), 1e-3);
    EXPECT_NEAR(*most, lost, 0.4 * std::abs(lost));
}

TEST(Bootstrap, IntervalsHoldTheirMeasuresAndAreNarrowForLargeImages) {
    const Measured all = measured(natural_pair(5 * 176, 3 * 176));
    const auto intervals = intervals_of(all.blocks);
    for (const std::string& id : bootstrap_measures()) {
        const double value = all.values.at(id);
        EXPECT_EQ(intervals.contains(id), value != 0) << id << ", an area that no pixel is in has none";
        if (!intervals.contains(id)) continue;
        EXPECT_LE(intervals.at(id).low, value) << id;
        EXPECT_GE(intervals.at(id).high, value) << id;
        EXPECT_LT(intervals.at(id).high - intervals.at(id).low, 0.2 * std::abs(value) + 1e-9) << id;
    }
    EXPECT_FALSE(intervals_of(measured(natural_pair(4 * 176, 3 * 176)).blocks).contains("ms_ssim"))
        << "twelve squares are too few";
}

/// The width of intervals over the spread of pictures of one kind; 1 where the intervals are right.
struct Calibration {
    double sum = 0, squares = 0, widths = 0;
    int pictures = 0;

    void add(double value, const Interval& interval) {
        sum += value;
        squares += value * value;
        widths += interval.high - interval.low;
        ++pictures;
    }
    double ratio() const {
        const double mean = sum / pictures;
        return widths / pictures / (2 * 1.96 * std::sqrt(squares / pictures - mean * mean));
    }
};

TEST(Bootstrap, IntervalsAreAsWideAsPicturesOfOneKindDiffer) {
    std::map<std::string, Calibration> calibrations;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Measured all = measured(patchwork(240, 10, seed));
        for (const auto& [id, interval] : intervals_of(all.blocks))
            calibrations[id].add(all.values.at(id), interval);
    }
    EXPECT_EQ(calibrations.size(), bootstrap_measures().size() - 1) << "all but MS-SSIM";
    for (const auto& [id, calibration] : calibrations) {
        // The deviation of 40 pictures is known to 11 %; windows reach over several patches.
        EXPECT_GT(calibration.ratio(), 0.65) << id;
        EXPECT_LT(calibration.ratio(), 1.4) << id;
    }
}

TEST(Bootstrap, IntervalOfMsSsimIsAsWideAsPicturesOfOneKindDiffer) {
    Calibration calibration;
    const std::vector<std::string> ids{"ms_ssim"};
    for (unsigned seed = 0; seed < 24; ++seed) {
        const Pair pair = patchwork(4 * 176, 40, seed);
        MapSums maps;
        MetricInput input = pair.input();
        input.maps = &maps;
        const double value = *evaluate(input, ids).at("ms_ssim").value;
        calibration.add(value, intervals_of(block_errors(input)).at("ms_ssim"));
    }
    EXPECT_GT(calibration.ratio(), 0.65);
    EXPECT_LT(calibration.ratio(), 1.4);
}

TEST(Bootstrap, OfSeveralViewsIsWiderThanOfEachBecauseViewsDiffer) {
    const BlockErrors low = blocks_of(std::vector<double>(100, 0.01)),
                      high = blocks_of(std::vector<double>(100, 0.09));
    const std::array<const BlockErrors*, 4> images{&low, &high, &low, &high};
    const auto interval = confidence_interval(resampled("rmse", images, 3));
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, 0.1, 0.06);
    EXPECT_NEAR(interval->high, 0.3, 0.06);
    EXPECT_GT(interval->high - interval->low, 0.1);
    EXPECT_FALSE(confidence_interval(values("rmse", low))) << "all drawn pictures are alike";
}

TEST(Bootstrap, HasNoIntervalFromFewerBlocksThanItTakesAndSaysSo) {
    for (const int side : {1, 2, 3, 4, 20}) {
        const BlockErrors blocks = block_errors(natural_pair(side, side).input());
        const bool told = static_cast<std::size_t>(side * side) >= kFewestBlocks;
        EXPECT_EQ(!intervals_of(blocks).empty(), told) << side;
        EXPECT_EQ(why_no_intervals(blocks).empty(), told) << side;
    }
    const std::string why = why_no_intervals(block_errors(natural_pair(1, 1).input()));
    EXPECT_NE(why.find("lie in 1 of the picture's blocks"), std::string::npos) << why;
}

TEST(Bootstrap, HasNoIntervalOfNoWidth) {
    for (const int side : {1, 5, 30, 90}) {
        for (const auto& [id, interval] : intervals_of(block_errors(natural_pair(side, side).input())))
            EXPECT_LT(interval.low, interval.high) << id << " of " << side;
    }
    EXPECT_TRUE(intervals_of(block_errors(Pair(90, 90).input())).empty()) << "of equal pictures";
}

// Blocks with errors of a mean of 1 in each pixel, of which they have 1 to 9.
TEST(RatioInterval, HoldsTheRatioAboutAsOftenAsItSays) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    int held = 0;
    constexpr int kTrials = 400;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> errors, pixels;
        for (int b = 0; b < 100; ++b) {
            pixels.push_back(static_cast<double>(random() % 9 + 1));
            errors.push_back(pixels.back() * (1 + 0.3 * normal(random)));
        }
        const auto interval = ratio_interval(errors, pixels);
        ASSERT_TRUE(interval);
        held += interval->low <= 1 && 1 <= interval->high;
    }
    // 380 with a standard deviation of 4.4.
    EXPECT_GE(held, 366);
    EXPECT_LE(held, 393);
}

TEST(RatioInterval, IsNotToldByFewBlocksNorByAlikeOnes) {
    const std::vector<double> none(300, 0), alike(300, 2);
    std::vector<double> few = none;
    for (std::size_t b = 0; b + 1 < kFewestBlocks; ++b) few[b] = 1 + static_cast<double>(b);
    EXPECT_FALSE(ratio_interval(few, few));
    EXPECT_FALSE(ratio_interval(none, none));
    EXPECT_FALSE(ratio_interval(alike, alike));
}

TEST(Bootstrap, HasNoIntervalWithoutAValidPixelNorForAnInfinitePsnr) {
    Pair pair = natural_pair(48, 48);
    pair.valid = Mask(48, 48, 0);
    const BlockErrors nothing = block_errors(pair.input());
    const std::array<const BlockErrors*, 1> images{&nothing};
    EXPECT_TRUE(confidence_intervals(images, 1).empty());
    EXPECT_FALSE(confidence_interval(values("psnr", blocks_of(std::vector<double>(20, 0)))));
    EXPECT_THROW(values("max_error", nothing), Error);
    // Where evaluate() left no sums, there is no interval either.
    EXPECT_FALSE(confidence_interval(values("ssim", blocks_of({1, 2, 3}))));
}

}  // namespace
}  // namespace aoscore
