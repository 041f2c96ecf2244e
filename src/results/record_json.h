#pragma once

#include "core/error.h"
#include "core/parameter_value.h"
#include "core/strict_json.h"
#include "results/record_of.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Writes and reads records whose members are listed by visit_members(): JSON on one side, structs of
/// numbers, texts, optionals, vectors, maps and other records on the other.
namespace aoscore {

namespace record_json {

using nlohmann::json;

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsMap : std::false_type {};
template <class T>
struct IsMap<std::map<std::string, T>> : std::true_type {};

template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::same_as<T, std::string> || std::same_as<T, json> ||
    std::same_as<T, ParameterValue>;

// ---- writing ----

template <class T>
json written(const T& value);

struct Writer {
    json object = json::object();
    template <class T>
    void operator()(const char* key, const T& member) {
        object[key] = written(member);
    }
    /// A list that is left out where it is empty, as files of earlier runs leave it out.
    template <class T>
    void where_any(const char* key, const std::vector<T>& list) {
        if (!list.empty()) (*this)(key, list);
    }
};

template <class T>
json written(const T& value) {
    if constexpr (Scalar<T>) {
        return value;
    } else if constexpr (IsOptional<T>::value) {
        return value ? written(*value) : json();
    } else if constexpr (IsVector<T>::value) {
        json array = json::array();
        for (const auto& element : value) array.push_back(written(element));
        return array;
    } else if constexpr (IsMap<T>::value) {
        json object = json::object();
        for (const auto& [key, element] : value) object[key] = written(element);
        return object;
    } else {
        Writer writer;
        visit_members(writer, value);
        return std::move(writer.object);
    }
}

/// Refuses NaN: JSON has none, and the library would write null, which stands for an empty value.
inline void require_finite(const json& value, const std::string& where) {
    if (value.is_number_float() && !std::isfinite(value.get<double>())) {
        throw internal_error("a result is NaN or infinite", where);
    }
    if (!value.is_structured()) return;
    for (const auto& [key, element] : value.items()) {
        require_finite(element, value.is_array() ? fmt::format("{}[{}]", where, key) : where + "." + key);
    }
}

// ---- reading ----

template <class T>
void read(const json& value, const std::string& where, T& member);

struct Reader {
    StrictObject object;
    template <class T>
    void operator()(const char* key, T& member) {
        read(object.raw(key), object.where(key), member);
    }
    template <class T>
    void where_any(const char* key, std::vector<T>& list) {
        list.clear();
        if (object.has(key)) (*this)(key, list);
    }
};

[[noreturn]] inline void refuse(const json& value, const std::string& where, std::string_view valid) {
    std::string shown = value.is_structured() ? value.type_name() : value.dump();
    throw file_error("is " + shown, where, std::string(valid));
}

template <std::integral T>
void read_integer(const json& value, const std::string& where, T& member) {
    constexpr std::string_view kValid = "a whole number in range";
    if (!value.is_number_integer()) refuse(value, where, kValid);
    if (value.is_number_unsigned()) {
        const auto number = value.get<std::uint64_t>();
        if (!std::in_range<T>(number)) refuse(value, where, kValid);
        member = static_cast<T>(number);
    } else {
        const auto number = value.get<std::int64_t>();
        if (!std::in_range<T>(number)) refuse(value, where, kValid);
        member = static_cast<T>(number);
    }
}

template <class T>
void read(const json& value, const std::string& where, T& member) {
    if constexpr (std::same_as<T, json>) {
        member = value;
    } else if constexpr (std::same_as<T, ParameterValue>) {
        member = parameter_value(value, where);
    } else if constexpr (std::same_as<T, std::string>) {
        if (!value.is_string()) refuse(value, where, "a text");
        member = value.get<std::string>();
    } else if constexpr (std::same_as<T, bool>) {
        if (!value.is_boolean()) refuse(value, where, "true or false");
        member = value.get<bool>();
    } else if constexpr (std::integral<T>) {
        read_integer(value, where, member);
    } else if constexpr (std::floating_point<T>) {
        if (!value.is_number()) refuse(value, where, "a number");
        member = value.get<T>();
    } else if constexpr (IsOptional<T>::value) {
        member.reset();
        if (!value.is_null()) read(value, where, member.emplace());
    } else if constexpr (IsVector<T>::value) {
        if (!value.is_array()) refuse(value, where, "an array");
        member.clear();
        for (std::size_t i = 0; i < value.size(); ++i) {
            read(value[i], fmt::format("{}[{}]", where, i), member.emplace_back());
        }
    } else if constexpr (IsMap<T>::value) {
        if (!value.is_object()) refuse(value, where, "an object");
        member.clear();
        for (const auto& [key, element] : value.items()) read(element, where + "." + key, member[key]);
    } else {
        Reader reader{StrictObject(value, where)};
        visit_members(reader, member);
        reader.object.finish();
    }
}

/// Writes the record as JSON. Throws internal_error where a number is NaN or infinite; `where` names the
/// record.
template <class T>
json checked_json(const T& record, const std::string& where) {
    json object = written(record);
    require_finite(object, where);
    return object;
}

/// Reads the record from JSON. Throws file_error for another form.
template <class T>
T record_from_json(const json& object, const std::string& where) {
    T record;
    read(object, where, record);
    return record;
}

/// Reads a file's record with its "schema_version". Throws file_error for another form or version.
template <class T>
T versioned_record_from_json(const json& object, const std::string& where) {
    Reader reader{StrictObject::of_file(object, where)};
    int schema_version = 0;
    reader("schema_version", schema_version);
    if (schema_version != T::kSchemaVersion) {
        throw file_error(fmt::format("is {}, of another version of this program", schema_version),
                         reader.object.where("schema_version"), fmt::format("{}", T::kSchemaVersion));
    }
    T record;
    visit_members(reader, record);
    reader.object.finish();
    return record;
}

}  // namespace record_json
}  // namespace aoscore
