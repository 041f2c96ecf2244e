#include "scene/gltf/checked_object.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aoscore::gltf {

using nlohmann::json;

namespace {

/// Makes `value` an integer when it is a whole number; says whether it did.
bool make_integer(json& value) {
    constexpr double kExact = 9007199254740992.0;  // 2^53
    if (value.is_number_unsigned()) return value.get<std::uint64_t>() <= static_cast<std::uint64_t>(kExact);
    if (value.is_number_integer()) return true;
    if (!value.is_number_float()) return false;
    const double number = value.get<double>();
    if (!(std::abs(number) <= kExact) || number != std::floor(number)) return false;
    value = static_cast<std::int64_t>(number);
    return true;
}

std::size_t index_of(json& value, const Place& place, std::size_t count) {
    const bool whole = make_integer(value);
    if (!whole || value.get<std::int64_t>() < 0 || value.get<std::uint64_t>() >= count) {
        throw file_error(
            whole ? fmt::format("index {} of {}", value.get<std::int64_t>(), count) : "is no index",
            place.text(), count == 0 ? "none" : fmt::format("0 to {}", count - 1));
    }
    return value.get<std::size_t>();
}

double finite_number(const json& value, const Place& place) {
    if (!value.is_number())
        throw file_error(fmt::format("is {}", value.type_name()), place.text(), "a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) throw file_error("is not finite", place.text(), "a number");
    return number;
}

}  // namespace

CheckedObject::CheckedObject(json& value, const Place& place) : value_(value), place_(place) {
    if (!value.is_object())
        throw file_error(fmt::format("is {}", value.type_name()), place.text(), "an object");
}

json* CheckedObject::find(std::string_view key) {
    const auto found = value_.find(key);
    return found == value_.end() ? nullptr : &*found;
}

json* CheckedObject::find_array(std::string_view key) {
    json* array = find(key);
    if (array != nullptr && !array->is_array())
        fail(key, fmt::format("is {}", array->type_name()), "an array");
    return array;
}

void CheckedObject::require(std::string_view key, std::string_view valid) const {
    if (!has(key)) fail(key, "is missing", std::string(valid));
}

void CheckedObject::fail(std::string_view key, std::string what, std::string valid) const {
    throw file_error(std::move(what), Place(place_, key).text(), std::move(valid));
}

std::optional<std::int64_t> CheckedObject::integer(std::string_view key, std::int64_t lowest,
                                                   std::int64_t highest) {
    json* value = find(key);
    if (value == nullptr) return std::nullopt;
    const bool whole = make_integer(*value);
    if (!whole || value->get<std::int64_t>() < lowest || value->get<std::int64_t>() > highest) {
        fail(key, whole ? fmt::format("is {}", value->get<std::int64_t>()) : "is no whole number",
             fmt::format("{} to {}", lowest, highest));
    }
    return value->get<std::int64_t>();
}

std::int64_t CheckedObject::required_integer(std::string_view key, std::int64_t lowest,
                                             std::int64_t highest) {
    require(key, "a whole number");
    return *integer(key, lowest, highest);
}

std::optional<std::size_t> CheckedObject::index(std::string_view key, std::size_t count) {
    json* value = find(key);
    if (value == nullptr) return std::nullopt;
    return index_of(*value, Place(place_, key), count);
}

std::size_t CheckedObject::required_index(std::string_view key, std::size_t count) {
    require(key, "an index");
    return *index(key, count);
}

std::optional<double> CheckedObject::number(std::string_view key) {
    const json* value = find(key);
    if (value == nullptr) return std::nullopt;
    return finite_number(*value, Place(place_, key));
}

std::optional<bool> CheckedObject::boolean(std::string_view key) {
    const json* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_boolean()) fail(key, fmt::format("is {}", value->type_name()), "true or false");
    return value->get<bool>();
}

std::string CheckedObject::text(std::string_view key) {
    const json* value = find(key);
    if (value == nullptr) return {};
    if (!value->is_string()) fail(key, fmt::format("is {}", value->type_name()), "a text");
    return value->get<std::string>();
}

std::string CheckedObject::required_text(std::string_view key) {
    require(key, "a text");
    return text(key);
}

std::vector<double> CheckedObject::numbers(std::string_view key, std::size_t size) {
    const json* array = find_array(key);
    if (array == nullptr) return {};
    if (array->size() != size) {
        fail(key, fmt::format("has {} elements", array->size()), fmt::format("{} numbers", size));
    }
    return number_list(key);
}

std::vector<double> CheckedObject::number_list(std::string_view key) {
    const json* array = find_array(key);
    if (array == nullptr) return {};
    const Place place(place_, key);
    std::vector<double> result;
    for (const json& value : *array) result.push_back(finite_number(value, Place(place, result.size())));
    return result;
}

bool CheckedObject::holds_numbers(std::string_view key, std::size_t size) {
    const json* array = find(key);
    return array != nullptr && array->is_array() && array->size() == size &&
           std::all_of(array->begin(), array->end(), [](const json& value) {
               return value.is_number() && std::isfinite(value.get<double>());
           });
}

std::vector<std::string> CheckedObject::texts(std::string_view key) {
    const json* array = find_array(key);
    std::vector<std::string> result;
    if (array == nullptr) return result;
    for (const json& value : *array) {
        if (!value.is_string()) fail(key, fmt::format("holds {}", value.type_name()), "texts");
        result.push_back(value.get<std::string>());
    }
    return result;
}

std::vector<std::size_t> CheckedObject::indices(std::string_view key, std::size_t count) {
    json* array = find_array(key);
    std::vector<std::size_t> result;
    if (array == nullptr) return result;
    const Place place(place_, key);
    for (json& value : *array) result.push_back(index_of(value, Place(place, result.size()), count));
    return result;
}

void CheckedObject::object(std::string_view key, const std::function<void(CheckedObject&)>& read) {
    json* value = find(key);
    if (value == nullptr) return;
    const Place place(place_, key);
    CheckedObject member(*value, place);
    read(member);
}

void CheckedObject::required_object(std::string_view key, const std::function<void(CheckedObject&)>& read) {
    require(key, "an object");
    object(key, read);
}

std::size_t CheckedObject::objects(std::string_view key,
                                   const std::function<void(CheckedObject&, std::size_t)>& read) {
    json* array = find_array(key);
    if (array == nullptr) return 0;
    const Place place(place_, key);
    for (std::size_t i = 0; i < array->size(); ++i) {
        const Place element_place(place, i);
        CheckedObject element((*array)[i], element_place);
        read(element, i);
    }
    return array->size();
}

void CheckedObject::members(const std::function<void(const std::string&)>& read) {
    for (const auto& [key, value] : value_.items()) read(key);
}

std::size_t CheckedObject::count(std::string_view key) {
    const json* array = find_array(key);
    return array == nullptr ? 0 : array->size();
}

}  // namespace aoscore::gltf
