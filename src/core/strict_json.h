#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// One of our own JSON files, read strictly: every key must be consumed, every value has the type and range
/// that its reader asks for, and each error names the file and the place. Get an object with
/// parse_json_file(), take members out of it, then call finish(), which rejects what was not taken.
class StrictObject {
  public:
    /// `where` as it appears in errors: "views.json: views[2]".
    StrictObject(const nlohmann::json& object, std::string where);
    /// The top level of the file `name`, whose members appear in errors as "views.json: views". "$schema", a
    /// text, may stand in it and is not read.
    static StrictObject of_file(const nlohmann::json& object, std::string name);

    bool has(std::string_view key) const;
    std::string text(std::string_view key);
    std::string text_or(std::string_view key, std::string fallback);
    bool boolean_or(std::string_view key, bool fallback);
    /// A finite number in [lowest, highest].
    double number(std::string_view key, double lowest, double highest);
    double number_or(std::string_view key, double fallback, double lowest, double highest);
    int integer(std::string_view key, int lowest, int highest);
    int integer_or(std::string_view key, int fallback, int lowest, int highest);
    /// Exactly `size` finite numbers.
    std::vector<double> numbers(std::string_view key, std::size_t size);
    std::vector<std::string> texts_or_empty(std::string_view key);
    StrictObject object(std::string_view key);
    /// The members of an array, each an object.
    std::vector<StrictObject> objects(std::string_view key);
    std::vector<StrictObject> objects_or_empty(std::string_view key);
    /// Members of any name, such as parameters by id: name and raw value, in the file's order of names.
    std::vector<std::pair<std::string, nlohmann::json>> members();
    /// The raw value, for readers that accept several types.
    const nlohmann::json& raw(std::string_view key);

    const std::string& where() const { return where_; }
    /// "file: place.key" for an error about a member.
    std::string where(std::string_view key) const { return where_ + before_key_ + std::string(key); }

    /// Throws file_error for the first key that nobody took.
    void finish() const;

  private:
    const nlohmann::json& take(std::string_view key, std::string_view type);

    const nlohmann::json* object_;
    std::string where_;
    const char* before_key_ = ".";
    std::set<std::string, std::less<>> taken_;
};

/// Parses the file; the top level must be an object. Throws file_error with the line of a syntax error.
nlohmann::json parse_json_file(const std::filesystem::path& path);

}  // namespace aoscore
