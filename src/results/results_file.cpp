#include "core/files.h"
#include "core/json_text.h"
#include "core/strict_json.h"
#include "results/results.h"

namespace aoscore {
namespace {

constexpr const char* kFileName = "results.json";

}  // namespace

void write_results(const Results& results, const std::filesystem::path& folder) {
    write_atomically(folder / kFileName, json_text(to_json(results), 1) + "\n");
}

Results read_results(const std::filesystem::path& path) {
    std::error_code ec;
    const std::filesystem::path file = std::filesystem::is_regular_file(path, ec) ? path : path / kFileName;
    return results_from_json(parse_json_file(file), file.string());
}

}  // namespace aoscore
