#include "screen/method/input_members.h"

#include "core/error.h"
#include "core/strict_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

/// Whether the member accepts every value of the parameter.
bool fits(const Parameter& parameter, const Parameter& member) {
    const bool within = parameter.lowest >= member.lowest && parameter.highest <= member.highest;
    const bool known = std::ranges::all_of(parameter.choices, [&](const std::string& choice) {
        return std::ranges::find(member.choices, choice) != member.choices.end();
    });
    return parameter.type == member.type && within && known;
}

bool is_reference(const ParameterValue& value) {
    return value.is_word() && value.word().starts_with('@');
}

void check_member(const Parameter& member, const ParameterValue& value, const MethodDescriptor& method,
                  const std::string& where) {
    const std::string valid = fmt::format("{}; or @ and a parameter that takes nothing else", member.valid());
    if (!is_reference(value)) {
        if (!member.accepts(value)) throw file_error(fmt::format("is {}", value.quoted()), where, valid);
        return;
    }
    const Parameter* parameter = method.find_parameter(value.word().substr(1));
    if (parameter == nullptr || !fits(*parameter, member))
        throw file_error(fmt::format("is {}", value.quoted()), where, valid);
}

}  // namespace

InputMembers parse_input_members(const MethodDescriptor& method, StrictObject object,
                                 const std::vector<Parameter>& members) {
    InputMembers input;
    for (const Parameter& member : members) {
        const std::string where = object.where(member.id);
        const ParameterValue value =
            object.has(member.id) ? parameter_value(object.raw(member.id), where) : member.default_value;
        check_member(member, value, method, where);
        input.members[member.id] = value;
    }
    object.finish();
    return input;
}

ParameterValue member_value(const InputMembers& input, const ParameterValues& parameters,
                            std::string_view member) {
    const ParameterValue& given = input.members.at(std::string(member));
    return is_reference(given) ? parameters.at(given.word().substr(1)) : given;
}

bool names_parameter(const InputMembers& input, std::string_view parameter) {
    const ParameterValue reference(fmt::format("@{}", parameter));
    return std::ranges::any_of(input.members, [&](const auto& member) { return member.second == reference; });
}

std::optional<ParameterValues> parameters_for(const InputMembers& input, const ParameterValues& wanted) {
    ParameterValues changes;
    for (const auto& [member, value] : wanted) {
        const ParameterValue& given = input.members.at(member);
        if (!is_reference(given) && given != value) return std::nullopt;
        if (is_reference(given)) changes[given.word().substr(1)] = value;
    }
    return changes;
}

}  // namespace aoscore
