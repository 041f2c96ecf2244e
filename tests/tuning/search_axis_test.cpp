#include "tuning/search_axis.h"

#include "core/error.h"
#include "screen/method/lengths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore {
namespace {

TEST(SearchAxes, OfEveryMethodHoldItsPresetAndStayInItsRanges) {
    for (const MethodDescriptor& method : load_methods()) {
        std::vector<SearchAxis> axes;
        try {
            axes = search_axes(method, "default", {}, true);
        } catch (const Error&) {
            continue;  // a method without a number to tune
        }
        for (const SearchAxis& axis : axes) {
            SCOPED_TRACE(method.id + " " + axis.parameter);
            const Parameter& p = *method.find_parameter(axis.parameter);
            EXPECT_NE(axis.parameter, method.reference_radius.parameter);
            EXPECT_NEAR(axis.value(axis.position(axis.published)), axis.published,
                        1e-9 * std::max(1.0, std::abs(axis.published)));
            for (const double position : {0.0, 0.3, 0.5, 1.0})
                EXPECT_TRUE(p.accepts(axis.on_view(axis.value(position), axis.reference_radius_m)));
            // A parameter's own limit ends no search: nothing lies beyond it.
            EXPECT_EQ(axis.ends_search(axis.low), p.lowest < axis.low);
            EXPECT_EQ(axis.ends_search(axis.high), p.highest > axis.high);
            EXPECT_FALSE(axis.ends_search(axis.value(0.5)) && !axis.whole);
        }
    }
}

// A view of a hundredth of the reference radius gets a hundredth of every length, as presets do.
TEST(SearchAxes, ScaleLengthsAsPresetsAreScaled) {
    for (const MethodDescriptor& method : load_methods()) {
        const std::optional<double> meant_m = reference_radius(method, "default");
        if (!meant_m) continue;
        const ParameterValues scaled = values_for_radius(method, *meant_m / 100, "default");
        for (const Parameter& p : method.parameters) {
            if (p.length_power == 0 || p.id == method.reference_radius.parameter) continue;
            const SearchAxis axis = search_axes(method, "default", {p.id}, true).front();
            EXPECT_NEAR(axis.on_view(axis.published, *meant_m / 100).number(), scaled.at(p.id).number(),
                        1e-12 * std::max(1.0, axis.published))
                << method.id << " " << p.id;
        }
    }
}

TEST(SearchAxes, RefuseWhatCannotBeTuned) {
    const auto methods = load_methods();
    const MethodDescriptor& gtao = find_method(methods, "gtao");
    for (const char* id : {"radius", "noise", "bent_weights", "nonsense"})
        EXPECT_THROW(search_axes(gtao, "default", {id}, true), Error) << id;
}

}  // namespace
}  // namespace aoscore
