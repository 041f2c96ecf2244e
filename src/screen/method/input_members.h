#pragma once

#include "screen/method/method.h"

#include <string_view>
#include <vector>

namespace aoscore {

class StrictObject;

/// Reads the settings of an input from a descriptor; a missing member has its default. Throws file_error for
/// a value that a member does not accept, and for a parameter that may have such a value.
InputMembers parse_input_members(const MethodDescriptor& method, StrictObject object,
                                 const std::vector<Parameter>& members);

/// The member's value for these parameters of the method.
ParameterValue member_value(const InputMembers& input, const ParameterValues& parameters,
                            std::string_view member);

/// Whether some member names this parameter.
bool names_parameter(const InputMembers& input, std::string_view parameter);

/// Changes of the method's parameters by which the members have these values. Empty where the descriptor
/// fixes another value of one.
std::optional<ParameterValues> parameters_for(const InputMembers& input, const ParameterValues& wanted);

}  // namespace aoscore
