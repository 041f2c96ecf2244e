#include "core/error.h"
#include "core/files.h"
#include "core/json_text.h"
#include "results/results.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace aoscore {
namespace {

constexpr const char* kFileName = "results.json";

/// More than twice what all claims take, with the sums of every block of their pictures.
constexpr std::size_t kLargest_bytes = std::size_t{128} << 20;
constexpr std::size_t kMostValues = 4 * kMostJsonValues;

/// The end of the string that begins at `from`, its quotation mark included.
std::size_t end_of_string(std::string_view json, std::size_t from) {
    std::size_t i = from + 1;
    while (json[i] != '"') i += json[i] == '\\' ? 2 : 1;
    return i + 1;
}

/// Puts each array of numbers in one line: those of blocks are long, and with a line for each number a third
/// of a file would be spaces.
std::string numbers_in_rows(std::string_view json) {
    std::string text;
    text.reserve(json.size());
    for (std::size_t i = 0; i < json.size();) {
        std::size_t end = i + 1;
        if (json[i] == '"') end = end_of_string(json, i);
        if (json[i] == '[') end = json.find_first_of("[]{\"", i + 1);
        const bool row = json[i] == '[' && json[end] == ']';
        std::ranges::copy_if(json.substr(i, end - i), std::back_inserter(text),
                             [&](char c) { return !row || (c != ' ' && c != '\n'); });
        i = end;
    }
    return text;
}

nlohmann::json parsed_results(const std::filesystem::path& file) {
    nlohmann::json parsed =
        parse_json_text(read_file(file, kLargest_bytes), file.string(), "a JSON object", kMostValues);
    if (!parsed.is_object()) throw file_error("the top level is no object", file.string(), "an object");
    return parsed;
}

}  // namespace

void write_results(const Results& results, const std::filesystem::path& folder) {
    write_atomically(folder / kFileName, numbers_in_rows(json_text(to_json(results), 1)) + "\n");
}

Results read_results(const std::filesystem::path& path) {
    std::error_code ec;
    const std::filesystem::path file = std::filesystem::is_directory(path, ec) ? path / kFileName : path;
    return results_from_json(parsed_results(file), file.string());
}

}  // namespace aoscore
