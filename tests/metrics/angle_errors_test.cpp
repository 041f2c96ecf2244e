#include "metrics/measures/angle_errors.h"

#include "core/error.h"
#include "metrics/signal_metric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace aoscore {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A row of pixels with directions in the plane of x and z at these angles from z.
SignalImage directions(const std::vector<double>& degrees, float length = 1) {
    SignalImage image(3, ImageF(static_cast<int>(degrees.size()), 1));
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        image[0].pixels[i] = length * static_cast<float>(std::sin(degrees[i] * kDegree));
        image[2].pixels[i] = length * static_cast<float>(std::cos(degrees[i] * kDegree));
    }
    return image;
}

SignalImage angles(const std::vector<double>& degrees) {
    SignalImage image(1, ImageF(static_cast<int>(degrees.size()), 1));
    for (std::size_t i = 0; i < degrees.size(); ++i)
        image[0].pixels[i] = static_cast<float>(degrees[i] * kDegree);
    return image;
}

double value(const std::map<std::string, MetricValue>& values, const std::string& id) {
    return values.at(id).value.value();
}

TEST(BentAngle, IsTheAngleWhateverTheLengths) {
    const SignalImage truth = directions({0, 10, 20, 90}, 0.5F), test = directions({0, 13, 16, 180}, 0.7F);
    const Mask valid(4, 1, 1);
    const auto values = evaluate_signal("bent_normal", {truth, test, valid, ImageF(4, 1, 0.0F)});
    EXPECT_NEAR(value(values, "bent_angle_mean"), (0 + 3 + 4 + 90) / 4.0, 1e-4);
    EXPECT_NEAR(value(values, "bent_angle_p95"), 90, 1e-4);
}

TEST(BentAngle, Of95PercentIsTheNearestRank) {
    std::vector<double> degrees;
    for (int i = 1; i <= 100; ++i) degrees.push_back(i);
    const SignalImage truth = directions(std::vector<double>(100, 0)), test = directions(degrees);
    const Mask valid(100, 1, 1);
    const auto values = evaluate_signal("bent_normal", {truth, test, valid, ImageF(100, 1, 0.0F)});
    EXPECT_NEAR(value(values, "bent_angle_p95"), 95, 1e-3);
    EXPECT_NEAR(value(values, "bent_angle_mean"), 50.5, 1e-3);
}

TEST(ConeError, HasASizeAndASign) {
    const SignalImage truth = angles({90, 60, 30}), test = angles({80, 60, 45});
    const auto values = evaluate_signal("cone_angle", {truth, test, Mask(3, 1, 1), ImageF(3, 1, 0.0F)});
    EXPECT_NEAR(value(values, "cone_error_mean"), 25.0 / 3, 1e-4);
    EXPECT_NEAR(value(values, "cone_bias"), 5.0 / 3, 1e-4);
    EXPECT_NEAR(value(values, "cone_error_p95"), 15, 1e-4);
}

TEST(AngleErrors, LeaveOutWhatTheTruthDoesNotKnowAndSaySo) {
    const SignalImage truth = directions({0, 0, 0}), test = directions({2, 50, 4});
    ImageF error(3, 1, 0.01F);
    error.pixels[1] = 0.5F;
    const auto values = evaluate_signal("bent_normal", {truth, test, Mask(3, 1, 1), error});
    EXPECT_NEAR(value(values, "bent_angle_mean"), 3, 1e-4);
    EXPECT_NE(values.at("bent_angle_mean").note.find("1 of 3"), std::string::npos);
    const auto none = evaluate_signal("bent_normal", {truth, test, Mask(3, 1, 1), ImageF(3, 1, 1.0F)});
    EXPECT_FALSE(none.at("bent_angle_mean").value);
    EXPECT_FALSE(none.at("bent_angle_mean").note.empty());
}

TEST(AngleErrors, OfWhatIsNotFiniteOrOfAnotherSizeAreRefused) {
    const SignalImage truth = directions({0, 0});
    SignalImage test = directions({0, 0});
    test[1].pixels[0] = NAN;
    const auto values = evaluate_signal("bent_normal", {truth, test, Mask(2, 1, 1), ImageF(2, 1, 0.0F)});
    EXPECT_FALSE(values.at("bent_angle_mean").value);
    EXPECT_THROW(evaluate_signal("bent_normal", {truth, directions({0}), Mask(2, 1, 1), ImageF(2, 1, 0.0F)}),
                 Error);
}

TEST(AngleErrors, AsAnImageHaveTheErrorOfEveryPixelThatCounts) {
    const SignalImage truth = directions({0, 10, 20, 30}), test = directions({5, 10, 50, 0});
    Mask valid(4, 1, 1);
    valid.pixels[1] = 0;
    ImageF error(4, 1, 0.01F);
    error.pixels[3] = 0.5F;
    const ImageF image = angle_error_image({truth, test, valid, error});
    EXPECT_NEAR(image.pixels[0], 5, 1e-4);
    EXPECT_NEAR(image.pixels[2], 30, 1e-4);
    EXPECT_TRUE(std::isnan(image.pixels[1])) << "is not valid";
    EXPECT_TRUE(std::isnan(image.pixels[3])) << "the truth does not know it";
    const SignalImage wide = angles({80}), narrow = angles({70});
    const Mask one(1, 1, 1);
    const ImageF sure(1, 1, 0.0F);
    EXPECT_NEAR(angle_error_image({wide, narrow, one, sure}).pixels[0], -10, 1e-4);
}

TEST(SignalMetrics, EachSignalBesideVisibilityHasSomeAndTheirIdsAreUnique) {
    std::set<std::string_view> ids;
    for (const SignalMetric& metric : signal_metrics()) {
        EXPECT_TRUE(ids.insert(metric.id).second) << metric.id;
        EXPECT_NO_THROW(signal(metric.signal));
        EXPECT_NE(metric.measure, nullptr);
        EXPECT_FALSE(metric.meaning.empty());
    }
    for (const std::string& id : further_signals()) {
        EXPECT_TRUE(std::ranges::any_of(signal_metrics(), [&](const SignalMetric& m) {
            return m.signal == id;
        })) << id;
    }
}

}  // namespace
}  // namespace aoscore
