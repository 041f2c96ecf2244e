#include "screen/method/lengths.h"

#include "core/error.h"
#include "hand_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace aoscore::testing {
namespace {

class Lengths : public ::testing::TestWithParam<std::string> {
  protected:
    const MethodDescriptor& method() const { return find_method(methods_, GetParam()); }
    std::vector<MethodDescriptor> methods_ = load_methods();
};

bool has_lengths(const MethodDescriptor& method) {
    return std::any_of(method.parameters.begin(), method.parameters.end(),
                       [](const Parameter& p) { return p.length_power != 0; });
}

TEST_P(Lengths, OfEveryPresetGrowWithTheRadiusByTheirPowerUnlessTheyAreAbsolute) {
    for (const auto& [preset, unused] : method().presets) {
        const auto reference_m = reference_radius(method(), preset);
        ASSERT_EQ(reference_m.has_value(), has_lengths(method())) << preset;
        if (!reference_m) continue;
        const ParameterValues own = method().values(preset);
        const ParameterValues drawn = values_for_radius(method(), 3 * *reference_m, preset);
        const bool absolute = method().absolute_presets.contains(preset);
        for (const Parameter& p : method().parameters) {
            if (p.length_power == 0 || absolute) {
                EXPECT_EQ(drawn.at(p.id), own.at(p.id)) << preset << ", " << p.id;
            } else {
                EXPECT_DOUBLE_EQ(drawn.at(p.id).number(),
                                 own.at(p.id).number() * std::pow(3.0, p.length_power))
                    << preset << ", " << p.id;
            }
        }
    }
}

TEST_P(Lengths, AtTheirReferenceRadiusAreTheOwnToTheLastBit) {
    for (const auto& [preset, unused] : method().presets) {
        const auto reference_m = reference_radius(method(), preset);
        if (!reference_m) continue;
        EXPECT_EQ(values_for_radius(method(), *reference_m, preset), method().values(preset)) << preset;
    }
}

// A run has one radius: where a method has a parameter for its radius, it gets the run's.
TEST_P(Lengths, NameTheRadiusThatEveryMethodIsDrawnWith) {
    const std::string& radius = method().reference_radius.parameter;
    ASSERT_EQ(radius.empty(), method().find_parameter("radius") == nullptr);
    if (radius.empty()) return;
    EXPECT_EQ(values_for_radius(method(), 0.3, "default").at(radius), 0.3);
    const std::string& of_truth = method().truth.radius_parameter;
    EXPECT_TRUE(of_truth.empty() || of_truth == radius) << of_truth;
}

TEST_P(Lengths, CanBeDrawnForAMicrometreAndForAThousandKilometres) {
    for (const auto& [preset, unused] : method().presets) {
        for (const double radius_m : {1e-6, 1e6})
            EXPECT_NO_THROW(values_for_radius(method(), radius_m, preset)) << preset << " at " << radius_m;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, Lengths, ::testing::ValuesIn(method_ids()),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(RunLengths, SetByHandAreTakenLiterally) {
    const auto methods = load_methods();
    const MethodDescriptor& alchemy = find_method(methods, "alchemy");
    const ParameterValues values = values_for_radius(alchemy, 1.0, "default", {{"sigma", 0.2}});
    EXPECT_EQ(values.at("sigma"), 0.2);
    EXPECT_EQ(values.at("radius"), 1.0);
    EXPECT_DOUBLE_EQ(values.at("epsilon").number(), 4 * 1e-4);  // an area, at twice the radius
    // A radius set by hand applies to that parameter alone: the other lengths stay those of the run.
    const ParameterValues wide = values_for_radius(alchemy, 1.0, "default", {{"radius", 5.0}});
    EXPECT_EQ(wide.at("radius"), 5.0);
    EXPECT_DOUBLE_EQ(wide.at("sigma").number(), 2 * 0.128);
}

TEST(RunLengths, OutOfTheirRangeAreAnErrorThatNamesMethodLengthAndRadius) {
    const auto methods = load_methods();
    try {
        values_for_radius(find_method(methods, "gtao"), 1e9, "default");
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::usage);
        for (const char* part : {"gtao.radius", "1e+09 m", "1e-09 to 10000000"})
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
}

TEST(RunLengths, OfFiltersAndOfTheLightsFollowTheRadiusToo) {
    const auto filters = load_filters();
    for (const MethodDescriptor& one : filters) {
        for (const double radius_m : {1e-6, 1e6})
            EXPECT_NO_THROW(values_for_radius(one, radius_m, "default"));
    }
    EXPECT_DOUBLE_EQ(values_for_radius(load_lighting(), 1.0, "default").at("reach").number(), 10);
    const MethodDescriptor& filter = find_method(filters, "normal-depth");
    // Gravås's decimetre belongs to a radius of 0.5 m.
    EXPECT_DOUBLE_EQ(values_for_radius(filter, 1.0, "default").at("distance_unit").number(), 0.2);
}

}  // namespace
}  // namespace aoscore::testing
