#include "screen/method/lengths.h"

#include "core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace aoscore {
namespace {

ParameterValues lengths_for_radius(const MethodDescriptor& method, double radius_m, double reference_m,
                                   const ParameterValues& own, const ParameterValues& overrides) {
    ParameterValues lengths;
    for (const Parameter& p : method.parameters) {
        if (p.length_power == 0 || overrides.contains(p.id)) continue;
        const bool is_radius = p.id == method.reference_radius.parameter;
        const double value =
            is_radius ? radius_m : own.at(p.id).number() * std::pow(radius_m / reference_m, p.length_power);
        if (!p.accepts(value)) {
            throw usage_error(
                fmt::format("becomes {:g} {} at an AO radius of {:g} m", value, p.unit, radius_m),
                method.id + "." + p.id, p.valid());
        }
        lengths[p.id] = value;
    }
    return lengths;
}

}  // namespace

std::optional<double> reference_radius(const MethodDescriptor& method, std::string_view preset) {
    if (!method.reference_radius.parameter.empty())
        return method.values(preset).at(method.reference_radius.parameter).number();
    if (method.reference_radius.metres > 0) return method.reference_radius.metres;
    return std::nullopt;
}

ParameterValues values_for_radius(const MethodDescriptor& method, double radius_m, std::string_view preset,
                                  const ParameterValues& overrides) {
    const ParameterValues own = method.values(preset, overrides);
    const std::optional<double> reference_m = reference_radius(method, preset);
    // At the reference radius itself the values do not change by a bit.
    if (!reference_m || radius_m == *reference_m || method.absolute_presets.contains(std::string(preset)))
        return own;
    ParameterValues values = lengths_for_radius(method, radius_m, *reference_m, own, overrides);
    values.insert(own.begin(), own.end());
    return values;
}

}  // namespace aoscore
