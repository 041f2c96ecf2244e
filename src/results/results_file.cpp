#include "core/error.h"
#include "core/files.h"
#include "core/json_text.h"
#include "results/results.h"

namespace aoscore {
namespace {

constexpr const char* kFileName = "results.json";

/// All claims together, with the sums of every block of their pictures, take more than other files may.
constexpr std::size_t kLargest_bytes = std::size_t{1} << 30;

nlohmann::json parsed_results(const std::filesystem::path& file) {
    nlohmann::json parsed = parse_json_text(read_file(file, kLargest_bytes), file.string(), "a JSON object");
    if (!parsed.is_object()) throw file_error("the top level is no object", file.string(), "an object");
    return parsed;
}

}  // namespace

void write_results(const Results& results, const std::filesystem::path& folder) {
    write_atomically(folder / kFileName, json_text(to_json(results), 1) + "\n");
}

Results read_results(const std::filesystem::path& path) {
    std::error_code ec;
    const std::filesystem::path file = std::filesystem::is_regular_file(path, ec) ? path : path / kFileName;
    return results_from_json(parsed_results(file), file.string());
}

}  // namespace aoscore
