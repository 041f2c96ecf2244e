#include "core/strict_json.h"

#include "core/error.h"
#include "core/files.h"
#include "core/json_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

namespace aoscore {

using nlohmann::json;

StrictObject::StrictObject(const json& object, std::string where)
    : object_(&object), where_(std::move(where)) {
    if (!object.is_object()) throw file_error(fmt::format("is {}", object.type_name()), where_, "an object");
}

StrictObject StrictObject::of_file(const json& object, std::string name) {
    StrictObject file(object, std::move(name));
    file.before_key_ = ": ";
    // Editors find the schema of a file by it.
    if (file.has("$schema")) file.text("$schema");
    return file;
}

bool StrictObject::has(std::string_view key) const {
    return object_->contains(key);
}

const json& StrictObject::take(std::string_view key, std::string_view type) {
    const auto found = object_->find(key);
    if (found == object_->end()) throw file_error("is missing", where(key), std::string(type));
    taken_.emplace(key);
    return *found;
}

const json& StrictObject::raw(std::string_view key) {
    return take(key, "a value");
}

std::string StrictObject::text(std::string_view key) {
    const json& value = take(key, "a text");
    if (!value.is_string()) throw file_error(fmt::format("is {}", value.type_name()), where(key), "a text");
    return value.get<std::string>();
}

std::string StrictObject::text_or(std::string_view key, std::string fallback) {
    return has(key) ? text(key) : std::move(fallback);
}

bool StrictObject::boolean_or(std::string_view key, bool fallback) {
    if (!has(key)) return fallback;
    const json& value = take(key, "true or false");
    if (!value.is_boolean()) throw file_error("is " + quoted_json(value), where(key), "true or false");
    return value.get<bool>();
}

double StrictObject::number(std::string_view key, double lowest, double highest) {
    const std::string valid = fmt::format("a number from {} to {}", lowest, highest);
    const json& value = take(key, valid);
    if (!value.is_number()) throw file_error("is " + quoted_json(value), where(key), valid);
    const double v = value.get<double>();
    if (!std::isfinite(v) || v < lowest || v > highest) {
        throw file_error("is " + quoted_json(value), where(key), valid);
    }
    return v;
}

double StrictObject::number_or(std::string_view key, double fallback, double lowest, double highest) {
    return has(key) ? number(key, lowest, highest) : fallback;
}

int StrictObject::integer(std::string_view key, int lowest, int highest) {
    const double v = number(key, lowest, highest);
    if (v != std::floor(v)) {
        throw file_error(fmt::format("is {}", v), where(key),
                         fmt::format("a whole number from {} to {}", lowest, highest));
    }
    return static_cast<int>(v);
}

int StrictObject::integer_or(std::string_view key, int fallback, int lowest, int highest) {
    return has(key) ? integer(key, lowest, highest) : fallback;
}

std::vector<double> StrictObject::numbers(std::string_view key, std::size_t size) {
    const std::string valid = fmt::format("an array of {} numbers", size);
    const json& value = take(key, valid);
    if (!value.is_array() || value.size() != size) throw file_error("has another form", where(key), valid);
    std::vector<double> result;
    for (const json& v : value) {
        if (!v.is_number() || !std::isfinite(v.get<double>())) {
            throw file_error("holds " + quoted_json(v), where(key), valid);
        }
        result.push_back(v.get<double>());
    }
    return result;
}

std::vector<std::string> StrictObject::texts_or_empty(std::string_view key) {
    if (!has(key)) return {};
    const json& value = take(key, "an array of texts");
    std::vector<std::string> result;
    if (!value.is_array()) throw file_error("has another form", where(key), "an array of texts");
    for (const json& v : value) {
        if (!v.is_string()) throw file_error("holds " + quoted_json(v), where(key), "an array of texts");
        result.push_back(v.get<std::string>());
    }
    return result;
}

StrictObject StrictObject::object(std::string_view key) {
    return StrictObject(take(key, "an object"), where(key));
}

std::vector<StrictObject> StrictObject::objects(std::string_view key) {
    const json& value = take(key, "an array of objects");
    if (!value.is_array()) throw file_error("has another form", where(key), "an array of objects");
    std::vector<StrictObject> result;
    for (std::size_t i = 0; i < value.size(); ++i) {
        result.emplace_back(value[i], fmt::format("{}[{}]", where(key), i));
    }
    return result;
}

std::vector<StrictObject> StrictObject::objects_or_empty(std::string_view key) {
    return has(key) ? objects(key) : std::vector<StrictObject>{};
}

std::vector<std::pair<std::string, json>> StrictObject::members() {
    std::vector<std::pair<std::string, json>> result;
    for (const auto& [key, value] : object_->items()) {
        taken_.insert(key);
        result.emplace_back(key, value);
    }
    return result;
}

void StrictObject::finish() const {
    for (const auto& [key, value] : object_->items()) {
        if (!taken_.contains(key)) {
            throw file_error("unknown key", where(key), fmt::format("{}", fmt::join(taken_, ", ")));
        }
    }
}

json parse_json_file(const std::filesystem::path& path) {
    json parsed = parse_json_text(read_file(path, std::size_t{64} << 20), path.string(), "a JSON object");
    if (!parsed.is_object()) throw file_error("the top level is no object", path.string(), "an object");
    return parsed;
}

}  // namespace aoscore
