#pragma once

#include <nlohmann/json_fwd.hpp>

#include <compare>
#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>

namespace aoscore {

class StrictObject;

/// The value of a parameter or an axis: true or false, a whole number, a real number, or a word such as the
/// name of a choice. Equal numbers are equal values, whether written as whole or real ones.
class ParameterValue {
  public:
    ParameterValue() = default;
    ParameterValue(bool value) : value_(value) {}
    ParameterValue(double number) : value_(number) {}
    template <std::integral T>
    requires(!std::same_as<T, bool>) ParameterValue(T number) : value_(static_cast<std::int64_t>(number)) {}
    ParameterValue(std::string word) : value_(std::move(word)) {}
    ParameterValue(std::string_view word) : value_(std::string(word)) {}
    ParameterValue(const char* word) : value_(std::string(word)) {}

    bool is_number() const { return is<std::int64_t>() || is<double>(); }
    bool is_boolean() const { return is<bool>(); }
    bool is_word() const { return is<std::string>(); }

    // Each throws internal_error for a value of another kind.
    double number() const;
    bool boolean() const;
    const std::string& word() const;

    /// The value as text: a word as it is, anything else as in JSON: "8", "0.5", "true".
    std::string text() const;
    /// The value as text() for messages, a word in quotation marks.
    std::string quoted() const;

    std::weak_ordering operator<=>(const ParameterValue& other) const;
    bool operator==(const ParameterValue& other) const { return (*this <=> other) == 0; }

    friend void to_json(nlohmann::json& json, const ParameterValue& value);

  private:
    template <class T>
    bool is() const {
        return std::holds_alternative<T>(value_);
    }

    std::variant<bool, std::int64_t, double, std::string> value_;
};
using ParameterValues = std::map<std::string, ParameterValue>;

void to_json(nlohmann::json& json, const ParameterValue& value);

/// Reads a value from a file. Throws file_error naming `where` for null, a list or an object.
ParameterValue parameter_value(const nlohmann::json& json, const std::string& where);
/// Reads all members of an object, as values by id.
ParameterValues parameter_values(StrictObject object);

}  // namespace aoscore
