#pragma once

#include "plan/plan.h"
#include "screen/screen.h"

#include <string>
#include <vector>

namespace aoscore {

/// A value that replaces a preset's, for a parameter of methods ("radius") or of their filters
/// ("filter.taps").
struct Assignment {
    std::string parameter;
    ParameterValue value;
};

/// Reads a number, true or false; anything else is a word, the name of a choice.
ParameterValue parse_value(const std::string& text);

/// Reads "radius=0.5", the value of `option`. Throws usage_error for another form.
Assignment parse_assignment(const std::string& text, const std::string& option = "--set");

/// Sets the value in the cell where its method, or the filter that it is run with, has the parameter, and
/// returns whether it has. Throws usage_error for an unknown method or filter.
bool assign(const Assignment& assignment, const std::vector<MethodDescriptor>& methods,
            const std::vector<MethodDescriptor>& filters, CellPlan& cell);

/// Every parameter that could be assigned in one of the cells, by name.
std::vector<std::string> assignable_parameters(const std::vector<CellPlan>& cells,
                                               const std::vector<MethodDescriptor>& methods,
                                               const std::vector<MethodDescriptor>& filters);

}  // namespace aoscore
