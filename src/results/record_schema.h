#pragma once

#include "results/record_json.h"

/// Describes records whose members are listed by visit_members() as JSON Schema (draft 2020-12), so that a
/// schema cannot differ from what is written and read.
namespace aoscore {

namespace record_json {

template <class T>
json described();

struct Describer {
    json properties = json::object();
    json required = json::array();
    template <class T>
    void operator()(const char* key, const T&) {
        properties[key] = described<T>();
        required.push_back(key);
    }
    /// A list that may be left out.
    template <class T>
    void where_any(const char* key, const std::vector<T>&) {
        properties[key] = described<std::vector<T>>();
    }
};

/// A schema of numbers, texts and truth values; empty, which accepts everything, for JSON of any form.
template <Scalar T>
json described_scalar() {
    if constexpr (std::same_as<T, std::string>) {
        return {{"type", "string"}};
    } else if constexpr (std::same_as<T, bool>) {
        return {{"type", "boolean"}};
    } else if constexpr (std::same_as<T, ParameterValue>) {
        return {{"type", {"number", "boolean", "string"}}};
    } else if constexpr (std::unsigned_integral<T>) {
        return {{"type", "integer"}, {"minimum", 0}};
    } else if constexpr (std::integral<T>) {
        return {{"type", "integer"}};
    } else if constexpr (std::floating_point<T>) {
        return {{"type", "number"}};
    } else {
        return json::object();
    }
}

/// The schema of what written() makes of a T: every member stands there but for lists that may be left
/// out, and no other.
template <class T>
json described() {
    if constexpr (Scalar<T>) {
        return described_scalar<T>();
    } else if constexpr (IsOptional<T>::value) {
        return {{"anyOf", {described<typename T::value_type>(), {{"type", "null"}}}}};
    } else if constexpr (IsVector<T>::value) {
        return {{"type", "array"}, {"items", described<typename T::value_type>()}};
    } else if constexpr (IsMap<T>::value) {
        return {{"type", "object"}, {"additionalProperties", described<typename T::mapped_type>()}};
    } else {
        Describer describer;
        const T record{};
        visit_members(describer, record);
        return {{"type", "object"},
                {"properties", std::move(describer.properties)},
                {"required", std::move(describer.required)},
                {"additionalProperties", false}};
    }
}

}  // namespace record_json
}  // namespace aoscore
