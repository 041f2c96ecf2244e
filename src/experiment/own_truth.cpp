#include "experiment/own_truth.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace aoscore {
namespace {

constexpr std::array<std::pair<Falloff, const char*>, 4> kFalloffs{{
    {Falloff::binary, "binary"},
    {Falloff::quadratic, "quadratic"},
    {Falloff::alchemy, "alchemy"},
    {Falloff::xegtao, "xegtao"},
}};

double number_parameter(const MethodDescriptor& method, const ParameterValues& parameters,
                        const std::string& id) {
    const auto found = parameters.find(id);
    if (found == parameters.end() || !found->second.is_number()) {
        throw file_error("\"" + id + "\" is no number parameter of the method",
                         method.id + "/method.json: truth");
    }
    return found->second.get<double>();
}

}  // namespace

TruthQuery own_truth(const MethodDescriptor& method, const ParameterValues& parameters) {
    TruthQuery query;
    bool known = false;
    for (const auto& [falloff, name] : kFalloffs) {
        if (method.truth.falloff == name) {
            query.falloff = falloff;
            known = true;
        }
    }
    if (!known) {
        throw file_error("unknown falloff " + method.truth.falloff, method.id + "/method.json: truth.falloff",
                         "binary, quadratic, alchemy, xegtao");
    }
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
    for (const auto& [value, name] : kFalloffs) {
        if (value == falloff) return name;
    }
    throw internal_error("falloff without a name");
}

std::string truth_id(const TruthQuery& query) {
    std::string id = falloff_name(query.falloff);
    if (std::isfinite(query.radius_m)) id += fmt::format("-{:g}", query.radius_m);
    if (query.falloff == Falloff::alchemy) id += fmt::format("-u{:g}", query.u_m);
    return id;
}

}  // namespace aoscore
