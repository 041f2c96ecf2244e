#include "jobs/own_truth.h"

#include "core/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

double number_parameter(const MethodDescriptor& method, const ParameterValues& parameters,
                        const std::string& id) {
    const auto found = parameters.find(id);
    if (found == parameters.end() || !found->second.is_number()) {
        throw file_error("\"" + id + "\" is no number parameter of the method",
                         method.id + "/method.json: truth");
    }
    return found->second.number();
}

}  // namespace

TruthQuery own_truth(const MethodDescriptor& method, const ParameterValues& parameters) {
    TruthQuery query;
    const auto known = std::ranges::find(kFalloffIds, method.truth.falloff);
    if (known == kFalloffIds.end()) {
        throw file_error("unknown falloff " + method.truth.falloff, method.id + "/method.json: truth.falloff",
                         fmt::format("{}", fmt::join(kFalloffIds, ", ")));
    }
    query.falloff = static_cast<Falloff>(known - kFalloffIds.begin());
    query.radius_m = method.truth.radius_parameter.empty()
                         ? std::numeric_limits<double>::infinity()
                         : number_parameter(method, parameters, method.truth.radius_parameter);
    if (!method.truth.radius_factor_parameter.empty()) {
        query.radius_m *= number_parameter(method, parameters, method.truth.radius_factor_parameter);
    }
    if (query.falloff == Falloff::alchemy) {
        query.u_m = number_parameter(method, parameters, method.truth.u_parameter);
    }
    return query;
}

std::string falloff_name(Falloff falloff) {
    return std::string(kFalloffIds[static_cast<std::size_t>(falloff)]);
}

std::string truth_id(const TruthQuery& query) {
    std::string id = falloff_name(query.falloff);
    if (std::isfinite(query.radius_m)) id += fmt::format("-{:g}", query.radius_m);
    if (query.falloff == Falloff::alchemy) id += fmt::format("-u{:g}", query.u_m);
    return id;
}

}  // namespace aoscore
