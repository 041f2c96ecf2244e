#include "jobs/own_truth.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

TEST(OwnTruth, OfEveryPresetIsNamedByItsDescriptor) {
    for (const MethodDescriptor& method : load_methods()) {
        for (const auto& [preset, values] : method.presets) {
            const TruthQuery query = own_truth(method, method.values(preset));
            EXPECT_GT(query.radius_m, 0) << method.id << "/" << preset;
            EXPECT_EQ(falloff_name(query.falloff), method.truth.falloff);
        }
    }
}

// The truth extends over the range of the taps: XeGTAO's radius is multiplied by 1.457, whatever it is.
TEST(OwnTruth, HasAFalloffAtAMultipliedRadiusWhereTheDescriptorSaysSo) {
    const auto methods = load_methods();
    MethodDescriptor xegtao = find_method(methods, "xegtao");
    EXPECT_EQ(own_truth(xegtao, xegtao.values("default")).radius_m, 0.5);
    xegtao.truth = {"xegtao", "radius", "radius_multiplier", ""};
    const TruthQuery usual = own_truth(xegtao, xegtao.values("default", {{"radius", 0.5}}));
    EXPECT_EQ(usual.falloff, Falloff::xegtao);
    EXPECT_DOUBLE_EQ(usual.radius_m, 0.5 * 1.457);
    const TruthQuery plain =
        own_truth(xegtao, xegtao.values("default", {{"radius", 2.0}, {"radius_multiplier", 1.0}}));
    EXPECT_DOUBLE_EQ(plain.radius_m, 2);
}

}  // namespace
}  // namespace aoscore
