#include "tuning/search_axis.h"

#include "core/error.h"
#include "screen/method/lengths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kFactor = 4;             // around a preset's value
constexpr double kPartOfRadius = 0.25;    // for a length that a preset leaves at 0
constexpr double kWidestPlainRange = 10;  // for a number that a preset leaves at 0

bool is_number(const Parameter& p) {
    return p.type == Parameter::Type::real || p.type == Parameter::Type::integer;
}

/// Says why a parameter cannot be tuned; empty where it can.
std::string obstacle(const MethodDescriptor& method, const Parameter& p) {
    if (!is_number(p)) return "is no number";
    if (!p.signal.empty()) return "does not affect visibility";
    if (p.id == method.reference_radius.parameter) return "is the AO radius, which every view sets";
    return {};
}

/// Sets the limits of the search around a preset's value.
void limit_search(const Parameter& p, double published, SearchAxis& axis) {
    if (published > 0) {
        axis.logarithmic = true;
        axis.low = std::max(p.lowest, published / kFactor);
        axis.high = std::min(p.highest, published * kFactor);
        if (axis.whole) axis.low = std::max(axis.low, 1.0);
        return;
    }
    const double widest = p.length_power > 0
                              ? kPartOfRadius * std::pow(axis.reference_radius_m, p.length_power)
                              : kWidestPlainRange;
    axis.low = std::max(p.lowest, published < 0 ? published * kFactor : -widest);
    axis.high = std::min(p.highest, published < 0 ? -published : widest);
}

SearchAxis axis_of(const MethodDescriptor& method, const Parameter& p, double published,
                   const std::string& preset) {
    SearchAxis axis;
    axis.parameter = p.id;
    axis.whole = p.type == Parameter::Type::integer;
    axis.published = published;
    const bool follows = !method.absolute_presets.contains(preset);
    axis.length_power = follows ? p.length_power : 0;
    axis.reference_radius_m = reference_radius(method, preset).value_or(1);
    limit_search(p, published, axis);
    axis.more_below = p.lowest < axis.low;
    axis.more_above = p.highest > axis.high;
    return axis;
}

}  // namespace

double SearchAxis::value(double position) const {
    const double at = std::clamp(position, 0.0, 1.0);
    const double v = logarithmic ? low * std::pow(high / low, at) : low + (high - low) * at;
    return whole ? std::clamp(std::round(v), std::ceil(low), std::floor(high)) : std::clamp(v, low, high);
}

double SearchAxis::position(double value) const {
    if (high <= low) return 0;
    const double at =
        logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return std::clamp(at, 0.0, 1.0);
}

bool SearchAxis::ends_search(double value) const {
    constexpr double kNear = 1e-3;  // of the positions
    const double at = position(value);
    return (more_below && at < kNear) || (more_above && at > 1 - kNear);
}

ParameterValue SearchAxis::on_view(double value, double radius_m) const {
    if (whole) return static_cast<std::int64_t>(value);
    return value * std::pow(radius_m / reference_radius_m, length_power);
}

std::vector<SearchAxis> search_axes(const MethodDescriptor& method, const std::string& preset,
                                    const std::vector<std::string>& wanted, bool counts) {
    const ParameterValues values = method.values(preset);
    std::vector<std::string> tunable;
    for (const Parameter& p : method.parameters) {
        if (obstacle(method, p).empty()) tunable.push_back(p.id);
    }
    const std::string valid = fmt::format("{}", fmt::join(tunable, ", "));
    const std::string where = method.id + " --parameters";
    std::vector<SearchAxis> axes;
    const auto add = [&](const Parameter& p) {
        SearchAxis axis = axis_of(method, p, values.at(p.id).number(), preset);
        if (axis.high > axis.low) axes.push_back(axis);
    };
    for (const std::string& id : wanted) {
        const Parameter* p = method.find_parameter(id);
        const std::string why = p == nullptr ? "does not exist" : obstacle(method, *p);
        if (!why.empty()) throw usage_error(id + " " + why, where, valid);
        add(*p);
    }
    if (wanted.empty()) {
        for (const Parameter& p : method.parameters) {
            if (obstacle(method, p).empty() && (counts || p.type == Parameter::Type::real)) add(p);
        }
    }
    if (axes.empty()) throw usage_error("nothing is left to tune", where, valid);
    return axes;
}

}  // namespace aoscore
