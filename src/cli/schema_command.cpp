#include "cli/command.h"
#include "core/files.h"
#include "core/folders.h"
#include "core/known_names.h"
#include "core/output.h"
#include "core/strict_json.h"
#include "results/results_schema.h"

#include <algorithm>
#include <memory>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".schema.json";

/// A kind of JSON file with its schema.
struct FileSchema {
    std::string id;
    nlohmann::json schema;
};

/// The schemas of reports/schemas, and that of results, which the list of its members makes; by id.
std::vector<FileSchema> file_schemas() {
    std::vector<FileSchema> all{{"results", results_schema()}};
    for (const auto& entry : fs::directory_iterator(data_dir() / "reports" / "schemas")) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(kEnding)) continue;
        all.push_back({name.substr(0, name.size() - kEnding.size()), parse_json_file(entry.path())});
    }
    std::ranges::sort(all, {}, &FileSchema::id);
    return all;
}

void print_schemas(const std::string& id) {
    const std::vector<FileSchema> all = file_schemas();
    if (!id.empty()) {
        print_result("{}\n", row_of(all, id, "no kind of file").schema.dump(2));
        return;
    }
    for (const FileSchema& one : all)
        print_result("{:<12} {}\n", one.id, one.schema.at("description").get<std::string>());
}

}  // namespace

CommandEntry add_schema_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand("schema", "Print the JSON Schema of a kind of file");
    const auto id = std::make_shared<std::string>();
    app->add_option("kind", *id, "Such as method, views or results [a list of all kinds]");
    return {app, [id] {
                print_schemas(*id);
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
