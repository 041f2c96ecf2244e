#include "screen/method/method.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/signal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

std::string valid_values(const Parameter& p) {
    switch (p.type) {
        case Parameter::Type::integer:
            return fmt::format("a whole number from {} to {}", p.lowest, p.highest);
        case Parameter::Type::real:
            return fmt::format("a number from {} to {}", p.lowest, p.highest);
        case Parameter::Type::boolean:
            return "true or false";
        case Parameter::Type::choice:
            return fmt::format("{}", fmt::join(p.choices, ", "));
    }
    return {};
}

bool in_range(const Parameter& p, const ParameterValue& value) {
    if (!value.is_number()) return false;
    const double v = value.number();
    if (p.type == Parameter::Type::integer && v != std::floor(v)) return false;
    return v >= p.lowest && v <= p.highest;
}

}  // namespace

bool Parameter::accepts(const ParameterValue& value) const {
    switch (type) {
        case Type::integer:
        case Type::real:
            return in_range(*this, value);
        case Type::boolean:
            return value.is_boolean();
        case Type::choice:
            return value.is_word() && std::ranges::find(choices, value.word()) != choices.end();
    }
    return false;
}

std::string Parameter::valid() const {
    return valid_values(*this);
}

std::string MethodDescriptor::shown_label() const {
    return role == MethodRole::bound ? label + " (bound)" : label;
}

const Parameter* MethodDescriptor::find_parameter(std::string_view parameter) const {
    return find_row(parameters, parameter);
}

bool MethodDescriptor::gives(std::string_view signal) const {
    if (signal == kVisibilitySignal) return true;
    return !passes.empty() && std::ranges::find(passes.back().outputs, signal) != passes.back().outputs.end();
}

PresetFilter MethodDescriptor::filter_of(const std::string& preset) const {
    const auto own = preset_filters.find(preset);
    return own == preset_filters.end() ? PresetFilter{} : own->second;
}

ParameterValues MethodDescriptor::values(std::string_view preset, const ParameterValues& overrides) const {
    const auto chosen = presets.find(std::string(preset));
    if (chosen == presets.end()) {
        std::vector<std::string> known;
        for (const auto& [name, unused] : presets) known.push_back(name);
        throw unknown_name("no preset", preset, known, id);
    }
    ParameterValues result;
    for (const Parameter& p : parameters) result[p.id] = p.default_value;
    for (const ParameterValues& layer : {chosen->second, overrides}) {
        for (const auto& [name, value] : layer) {
            const Parameter* parameter = find_parameter(name);
            if (parameter == nullptr) {
                throw unknown_name("no parameter", name, ids_of(parameters), id);
            }
            if (!parameter->accepts(value)) {
                throw usage_error(fmt::format("is {}", value.quoted()), id + "." + name, parameter->valid());
            }
            result[name] = value;
        }
    }
    return result;
}

ParameterValues visibility_values(const MethodDescriptor& method, ParameterValues values) {
    for (const Parameter& p : method.parameters) {
        if (!p.signal.empty()) values.erase(p.id);
    }
    return values;
}

const MethodDescriptor& find_method(const std::vector<MethodDescriptor>& methods, std::string_view id) {
    return row_of(methods, id, "no method or filter");
}

}  // namespace aoscore
