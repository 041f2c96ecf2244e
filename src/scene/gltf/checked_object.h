#pragma once

#include "scene/gltf/place.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore::gltf {

/// An object of a glTF document whose members are checked as they are read: each has the type and the range
/// that its reader asks for, or a file_error names the place. Members nobody asks for are legal. Whole
/// numbers written as 3.0 are legal JSON for an integer; they are rewritten in place, because later readers
/// do not know that.
class CheckedObject {
  public:
    /// Throws when `value` is not an object. Both arguments must outlive this object.
    CheckedObject(nlohmann::json& value, const Place& place);

    const Place& place() const { return place_; }
    bool has(std::string_view key) const { return value_.contains(key); }
    void erase(std::string_view key) { value_.erase(std::string(key)); }

    std::optional<std::int64_t> integer(std::string_view key, std::int64_t lowest, std::int64_t highest);
    std::int64_t required_integer(std::string_view key, std::int64_t lowest, std::int64_t highest);
    /// Reads an index into an array of `count` elements.
    std::optional<std::size_t> index(std::string_view key, std::size_t count);
    std::size_t required_index(std::string_view key, std::size_t count);
    std::optional<double> number(std::string_view key);
    std::optional<bool> boolean(std::string_view key);
    /// Reads a text; empty when absent.
    std::string text(std::string_view key);
    std::string required_text(std::string_view key);
    /// Reads exactly `size` finite numbers; empty when absent.
    std::vector<double> numbers(std::string_view key, std::size_t size);
    /// Reads any number of finite numbers; empty when absent.
    std::vector<double> number_list(std::string_view key);
    /// Whether the member is an array of exactly `size` finite numbers.
    bool holds_numbers(std::string_view key, std::size_t size);
    std::vector<std::string> texts(std::string_view key);
    /// Reads indices into an array of `count` elements; empty when absent.
    std::vector<std::size_t> indices(std::string_view key, std::size_t count);

    /// Calls `read` with the member when it is there.
    void object(std::string_view key, const std::function<void(CheckedObject&)>& read);
    void required_object(std::string_view key, const std::function<void(CheckedObject&)>& read);
    /// Calls `read` with each element, all of them objects. Returns how many there are; 0 when absent.
    std::size_t objects(std::string_view key, const std::function<void(CheckedObject&, std::size_t)>& read);
    /// Calls `read` with the key of every member.
    void members(const std::function<void(const std::string&)>& read);
    /// The number of elements of an array member, 0 when absent.
    std::size_t count(std::string_view key);

    /// Throws a file_error at a member.
    [[noreturn]] void fail(std::string_view key, std::string what, std::string valid = {}) const;

  private:
    nlohmann::json* find(std::string_view key);
    nlohmann::json* find_array(std::string_view key);
    void require(std::string_view key, std::string_view valid) const;

    nlohmann::json& value_;
    const Place& place_;
};

}  // namespace aoscore::gltf
