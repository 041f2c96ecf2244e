#include "core/parameter_value.h"

#include "core/error.h"
#include "core/json_text.h"
#include "core/strict_json.h"

namespace aoscore {
namespace {

[[noreturn]] void refuse(const ParameterValue& value, const char* expected) {
    throw internal_error("the value is " + value.quoted() + ", not " + expected, "a parameter");
}

}  // namespace

double ParameterValue::number() const {
    if (const auto* whole = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&value_)) return *real;
    refuse(*this, "a number");
}

bool ParameterValue::boolean() const {
    if (const bool* value = std::get_if<bool>(&value_)) return *value;
    refuse(*this, "true or false");
}

const std::string& ParameterValue::word() const {
    if (const auto* value = std::get_if<std::string>(&value_)) return *value;
    refuse(*this, "a word");
}

std::string ParameterValue::text() const {
    return is_word() ? word() : quoted();
}

std::string ParameterValue::quoted() const {
    return json_text(*this);
}

std::weak_ordering ParameterValue::operator<=>(const ParameterValue& other) const {
    if (is_number() && other.is_number()) return std::weak_order(number(), other.number());
    if (is_number() != other.is_number() || value_.index() != other.value_.index())
        return value_.index() <=> other.value_.index();
    return is_word() ? std::weak_order(word(), other.word()) : std::weak_order(boolean(), other.boolean());
}

void to_json(nlohmann::json& json, const ParameterValue& value) {
    std::visit([&](const auto& held) { json = held; }, value.value_);
}

ParameterValue parameter_value(const nlohmann::json& json, const std::string& where) {
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_string()) return json.get<std::string>();
    // A whole number beyond 64 bits becomes a real one, as JSON itself has only one kind of number.
    if (json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX) return json.get<double>();
    if (json.is_number_integer()) return json.get<std::int64_t>();
    if (json.is_number_float()) return json.get<double>();
    throw file_error("is " + quoted_json(json), where, "a number, true, false or a word");
}

ParameterValues parameter_values(StrictObject object) {
    ParameterValues values;
    for (const auto& [id, value] : object.members()) values[id] = parameter_value(value, object.where(id));
    return values;
}

}  // namespace aoscore
