// Claims about every row of the table of metrics, also of rows added later.
#include "core/error.h"
#include "core/threads.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/bootstrap.h"
#include "metrics/roles.h"
#include "pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace aoscore {

void PrintTo(const Metric& row, std::ostream* out) {
    *out << row.id;
}

namespace {

using ::testing::HasSubstr;
using testing::mask_out;
using testing::natural_pair;
using testing::Pair;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class EveryMetric : public ::testing::TestWithParam<Metric> {};

INSTANTIATE_TEST_SUITE_P(Table, EveryMetric, ::testing::ValuesIn(metrics()),
                         [](const auto& row) { return std::string(row.param.id); });

TEST_P(EveryMetric, HasAValueForAnOrdinaryPair) {
    const Pair pair = natural_pair(200, 180);
    const ImageF standard_error(200, 180, 0.01F);
    const MetricValue measured = GetParam().measure(pair.input(&standard_error));
    ASSERT_TRUE(measured.value) << measured.note;
    EXPECT_TRUE(std::isfinite(*measured.value));
}

TEST_P(EveryMetric, IgnoresWhatMaskedPixelsHold) {
    Pair pair = natural_pair(200, 180);
    mask_out(pair, 0.6);
    ImageF standard_error(200, 180, 0.01F);
    const MetricValue before = GetParam().measure(pair.input(&standard_error));
    ASSERT_TRUE(before.value) << before.note;
    for (const float poison : {0.0F, 1.0F, -1e30F, kNan, kInfinity}) {
        for (std::size_t i = 0; i < pair.valid.size(); ++i) {
            if (pair.valid.pixels[i] != 0) continue;
            pair.truth.pixels[i] = poison;
            pair.test.pixels[i] = 0.25F * poison;
            standard_error.pixels[i] = poison;
        }
        const MetricValue after = GetParam().measure(pair.input(&standard_error));
        EXPECT_EQ(before.value, after.value) << poison;
        EXPECT_EQ(before.note, after.note) << poison;
    }
}

TEST_P(EveryMetric, IsUndefinedWhereTheMaskCoversEverything) {
    Pair pair = natural_pair(200, 180);
    pair.valid = Mask(200, 180, 0);
    const ImageF standard_error(200, 180, 0.01F);
    const MetricValue measured = GetParam().measure(pair.input(&standard_error));
    EXPECT_FALSE(measured.value);
    EXPECT_EQ(measured.note, "no valid pixel");
}

TEST_P(EveryMetric, IsUndefinedForAnImageOfNoPixels) {
    const Pair pair(0, 0);
    EXPECT_FALSE(GetParam().measure(pair.input()).value);
}

TEST_P(EveryMetric, IsNeverNanButEmptyWhereAValidPixelIsNotFinite) {
    for (const float poison : {kNan, kInfinity, -kInfinity}) {
        Pair pair = natural_pair(200, 180);
        pair.test.at(90, 90) = poison;
        const ImageF standard_error(200, 180, 0.01F);
        const MetricValue measured = GetParam().measure(pair.input(&standard_error));
        EXPECT_FALSE(measured.value) << poison;
        EXPECT_THAT(measured.note, HasSubstr("NaN or infinite")) << poison;
    }
}

TEST_P(EveryMetric, DoesNotDependOnTheNumberOfThreads) {
    Pair pair = natural_pair(200, 180);
    mask_out(pair, 0.8);
    const ImageF standard_error(200, 180, 0.01F);
    std::set<std::optional<double>> values;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        values.insert(GetParam().measure(pair.input(&standard_error)).value);
    }
    set_thread_count(0);
    EXPECT_EQ(values.size(), 1U);
}

TEST_P(EveryMetric, RefusesImagesOfSeveralSizes) {
    const Pair small = natural_pair(190, 180), large = natural_pair(200, 180);
    const ImageF other_error(180, 200, 0.01F);
    for (const MetricInput& input : {MetricInput{small.truth, large.test, small.valid},
                                     MetricInput{large.truth, large.test, small.valid},
                                     MetricInput{large.truth, large.test, large.valid, &other_error}}) {
        try {
            GetParam().measure(input);
            ADD_FAILURE() << "accepted";
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::sizes_differ);
        }
    }
}

TEST_P(EveryMetric, SaysAllThatAPageNeeds) {
    EXPECT_FALSE(GetParam().label.empty());
    EXPECT_FALSE(GetParam().in_text.empty());
    EXPECT_GE(GetParam().decimals, 0);
    EXPECT_THAT(std::string(GetParam().meaning), ::testing::EndsWith("."));
}

TEST_P(EveryMetric, HasAnIntervalWhereItsRowSaysHow) {
    const auto& measures = bootstrap_measures();
    EXPECT_EQ(std::ranges::count(measures, GetParam().id), GetParam().resampled != nullptr ? 1 : 0);
}

TEST_P(EveryMetric, NamesAnotherRowForItselfWithoutNoise) {
    if (GetParam().without_noise.empty()) return;
    EXPECT_NE(metric(GetParam().without_noise).id, GetParam().id);
}

TEST(MetricRoles, AreRowsOfTheTableThatAreMeasuredUnrankedToo) {
    for (const char* id :
         {kRankingMetric, kNoisyRankingMetric, kBiasMetric, kStructureMetric, kPerceptualMetric})
        EXPECT_EQ(metric(id).id, id);
    const std::vector<std::string> unranked = unranked_metrics();
    for (const char* id : {kRankingMetric, kNoisyRankingMetric, kBiasMetric, kStructureMetric})
        EXPECT_NE(std::ranges::find(unranked, id), unranked.end())
            << id << " is shown against methods' own truths";
    EXPECT_EQ(metric(kNoisyRankingMetric).without_noise, kRankingMetric);
}

TEST_P(EveryMetric, IsToldByAnExactTruthAndByNoNoisierOneThatHidesIt) {
    bool before = true;
    for (const double variance : {0.0, 1e-5, 1e-3, 1e-1}) {
        const std::vector<std::string> told = told_metrics(variance);
        const bool now = std::ranges::find(told, GetParam().id) != told.end();
        EXPECT_TRUE(before || !now) << "at a noise of variance " << variance;
        EXPECT_TRUE(now || variance > 0);
        EXPECT_TRUE(now || GetParam().noise == Metric::Noise::extrapolated);
        before = now;
    }
    const std::vector<std::string> asked{std::string(GetParam().id)};
    EXPECT_EQ(told_metrics(0, asked), asked);
}

// A metric that is best for identical images must be worse for each of these, whichever way it points.
TEST_P(EveryMetric, DoesNotPraiseABlankImage) {
    const Pair good = natural_pair(200, 180);
    ImageF standard_error(200, 180, 0.001F);
    const auto badness = [&](const Pair& pair) {
        const MetricValue measured = GetParam().measure(pair.input(&standard_error));
        if (!measured.value) return std::numeric_limits<double>::infinity();
        switch (GetParam().better) {
            case Metric::Better::lower:
                return *measured.value;
            case Metric::Better::higher:
                return -*measured.value;
            case Metric::Better::nearer_zero:
                return std::abs(*measured.value);
        }
        return 0.0;
    };
    for (const float blank : {0.0F, 1.0F}) {
        Pair blank_test = good, blank_truth = good;
        blank_test.test = ImageF(200, 180, blank);
        blank_truth.truth = ImageF(200, 180, blank);
        EXPECT_GT(badness(blank_test), badness(good)) << "test " << blank;
        EXPECT_GT(badness(blank_truth), badness(good)) << "truth " << blank;
    }
}

TEST(Evaluate, GivesEveryRowOrThoseNamed) {
    const Pair pair = natural_pair(32, 32);
    EXPECT_EQ(evaluate(pair.input()).size(), metrics().size());
    const std::vector<std::string> ids = {"mae", "bias"};
    const auto values = evaluate(pair.input(), ids);
    EXPECT_EQ(values.size(), 2U);
    EXPECT_TRUE(values.contains("mae") && values.contains("bias"));
}

TEST(Evaluate, UnknownMetricIsAnErrorThatListsTheKnownOnes) {
    const Pair pair = natural_pair(32, 32);
    const std::vector<std::string> ids = {"rsme"};
    try {
        evaluate(pair.input(), ids);
        FAIL() << "accepted";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::usage);
        EXPECT_THAT(e.what(), HasSubstr("rsme"));
        EXPECT_THAT(e.what(), HasSubstr("rmse, rmse_debiased, mae"));
    }
}

TEST(Evaluate, AllNanHasNoValueAtAllAndSaysHowManyPixels) {
    Pair pair = natural_pair(200, 180);
    pair.truth = ImageF(200, 180, 0.5F);
    pair.test = ImageF(200, 180, kNan);
    for (const auto& [id, measured] : evaluate(pair.input())) {
        EXPECT_FALSE(measured.value) << id;
        EXPECT_THAT(measured.note, HasSubstr("36000 valid pixels")) << id;
    }
}

TEST(Table, IdsDiffer) {
    std::set<std::string_view> ids;
    for (const Metric& row : metrics()) ids.insert(row.id);
    EXPECT_EQ(ids.size(), metrics().size());
}

}  // namespace
}  // namespace aoscore
