#include "stress/stress_subjects.h"

#include "jobs/own_truth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

// The reference's radius where no method asks for another, metres in the base.
constexpr double kRadius_m = 0.5;

// The parameter that the radius axis changes: the truth's, else the one named radius.
std::string radius_parameter(const MethodDescriptor& method) {
    if (!method.truth.radius_parameter.empty()) return method.truth.radius_parameter;
    return method.find_parameter("radius") != nullptr ? "radius" : "";
}

// Scales a method's values: lengths grow with the scene, areas with its square.
ParameterValues scaled_values(const MethodDescriptor& method, const std::string& preset,
                              const StressCase& stress, const std::string& radius) {
    ParameterValues values = method.values(preset);
    ParameterValues changed;
    for (const Parameter& p : method.parameters) {
        double factor = std::pow(stress.length_scale, p.length_power);
        if (p.id == radius) factor *= stress.radius_scale;
        if (factor != 1) changed[p.id] = values.at(p.id).number() * factor;
    }
    return changed.empty() ? values : method.values(preset, changed);
}

std::string performance_preset(const MethodDescriptor& method) {
    for (const auto& [preset, values] : method.presets) {
        if (preset.starts_with("performance")) return preset;
    }
    return {};
}

// Fills in the request of the reference or the bound.
void traced_request(StressJudgement judgement, const StressCase& stress, StressRequest& result) {
    const bool is_bound = result.subject->kind == "bound";
    if (is_bound && judgement == StressJudgement::same_picture) {
        result.skipped = "is traced where the picture changes";
    } else if (!stress.has_truth) {
        result.skipped = "is not traced here";
    } else {
        result.own = reference_query(stress);
        result.contestant = is_bound ? one_layer_bound(result.own) : true_image(result.own);
    }
}

// Fills in the request of a method, or of a filter over one.
void drawn_request(const StressCase& stress, std::uint64_t seed, StressRequest& result) {
    const StressSubject& subject = *result.subject;
    const std::string radius = radius_parameter(*subject.method);
    if (stress.radius_scale != 1 && radius.empty()) {
        result.skipped = "has no radius";
        return;
    }
    if (stress.performance_presets_only) {
        result.preset = performance_preset(*subject.method);
        if (result.preset.empty() || subject.filter != nullptr) {
            result.skipped = "has no performance preset";
            return;
        }
    }
    MethodRequest request;
    request.method = subject.method;
    request.seed = seed;
    stress.modes.apply_to(request);
    request.parameters = scaled_values(*subject.method, result.preset, stress, radius);
    if (subject.filter != nullptr) {
        request.filter = subject.filter;
        request.filter_parameters = scaled_values(*subject.filter, "default", stress, "");
    }
    result.own = own_truth(*subject.method, request.parameters);
    result.contestant = contestant_of(std::move(request));
}

}  // namespace

std::map<std::string, std::string> StressSubject::limits() const {
    if (kind == "bound") {
        const std::string reason =
            "What lies outside of the picture, behind its first surface or edge-on is not in one depth "
            "layer.";
        return {{"radius", reason}, {"tilt", reason}, {"inside", reason}};
    }
    if (method == nullptr) return {};
    std::map<std::string, std::string> all = filter != nullptr ? filter->limits : method->limits;
    if (filter != nullptr) {
        for (const auto& [axis, reason] : method->limits)
            all.emplace(axis, "As " + method->label + ", whose output it is given: " + reason);
    }
    return all;
}

std::vector<StressSubject> stress_subjects(const Registry& registry,
                                           const std::vector<std::string>& methods) {
    std::vector<StressSubject> subjects = {
        {"reference", "Reference (ray tracer)", "reference", nullptr, nullptr},
        {"one-layer", "Bound of one depth layer", "bound", nullptr, nullptr},
    };
    for (const std::string& id : methods) find_method(registry.methods, id);
    for (const MethodDescriptor& method : registry.methods) {
        if (methods.empty() || std::find(methods.begin(), methods.end(), method.id) != methods.end())
            subjects.push_back({method.id, method.shown_label(), "method", &method, nullptr});
    }
    const MethodDescriptor& filtered = find_method(registry.methods, kFilteredMethod);
    for (const MethodDescriptor& filter : registry.filters)
        subjects.push_back({filter.id, filter.label, "filter", &filtered, &filter});
    return subjects;
}

TruthQuery reference_query(const StressCase& stress) {
    return {Falloff::binary, kRadius_m * stress.length_scale * stress.radius_scale, 0};
}

StressRequest stress_request(const StressSubject& subject, StressJudgement judgement,
                             const StressCase& stress, std::uint64_t seed) {
    StressRequest result;
    result.subject = &subject;
    if (subject.method == nullptr) {
        traced_request(judgement, stress, result);
    } else {
        drawn_request(stress, seed, result);
    }
    return result;
}

}  // namespace aoscore
