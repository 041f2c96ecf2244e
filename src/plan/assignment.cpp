#include "plan/assignment.h"

#include "core/error.h"
#include "plan/resolved_cell.h"

#include <set>

namespace aoscore {

ParameterValue parse_value(const std::string& text) {
    const auto value = nlohmann::json::parse(text, nullptr, false);
    return value.is_number() || value.is_boolean() ? parameter_value(value, text) : ParameterValue(text);
}

Assignment parse_assignment(const std::string& text, const std::string& option) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw usage_error("\"" + text + "\" is no assignment", option, "parameter=value");
    return {text.substr(0, equals), parse_value(text.substr(equals + 1))};
}

bool assign(const Assignment& assignment, const std::vector<MethodDescriptor>& methods,
            const std::vector<MethodDescriptor>& filters, CellPlan& cell) {
    const auto& [parameter, value] = assignment;
    const MethodDescriptor& method = find_method(methods, cell.method);
    if (!parameter.starts_with(kFilterPrefix)) {
        if (method.find_parameter(parameter) == nullptr) return false;
        cell.overrides[parameter] = value;
        return true;
    }
    const std::string id = parameter.substr(kFilterPrefix.size()), filter = filter_of(cell, method).filter;
    if (filter == "none" || find_method(filters, filter).find_parameter(id) == nullptr) return false;
    cell.filter_overrides[id] = value;
    return true;
}

std::vector<std::string> assignable_parameters(const std::vector<CellPlan>& cells,
                                               const std::vector<MethodDescriptor>& methods,
                                               const std::vector<MethodDescriptor>& filters) {
    std::set<std::string> names;
    for (const CellPlan& cell : cells) {
        const MethodDescriptor& method = find_method(methods, cell.method);
        for (const Parameter& p : method.parameters) names.insert(p.id);
        const std::string filter = filter_of(cell, method).filter;
        if (filter == "none") continue;
        for (const Parameter& p : find_method(filters, filter).parameters)
            names.insert(std::string(kFilterPrefix) + p.id);
    }
    return {names.begin(), names.end()};
}

}  // namespace aoscore
