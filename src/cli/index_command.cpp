#include "cli/command.h"
#include "core/log.h"
#include "core/output.h"
#include "page/index/index_page.h"
#include "results/results.h"
#include "results/stress_results.h"
#include "results/tuning_record.h"
#include "verdict/rankings.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResultsFile = "results.json";

struct IndexOptions {
    std::vector<fs::path> folders;
    fs::path out = "index";
};

/// The results files of a path: itself, its own, or those of the folders in it, by name.
std::vector<fs::path> results_files(const fs::path& path) {
    if (fs::is_regular_file(path)) return {path};
    if (fs::exists(path / kResultsFile)) return {path / kResultsFile};
    std::vector<fs::path> files;
    std::error_code ec;
    fs::recursive_directory_iterator folders(path, fs::directory_options::skip_permission_denied, ec);
    for (; !ec && folders != fs::recursive_directory_iterator(); folders.increment(ec)) {
        if (!folders->is_directory() || !fs::exists(folders->path() / kResultsFile)) continue;
        files.push_back(folders->path() / kResultsFile);
        folders.disable_recursion_pending();
    }
    std::ranges::sort(files);
    return files;
}

void add_file(IndexBuilder& index, const fs::path& file) {
    try {
        index.add(ranked_anew(read_results(file)), file.parent_path());
    } catch (const Error& e) {
        log_warning(e.what());
        index.add_unreadable(file, e.what());
    }
}

/// Refuses the folder of a run, whose own page the index would take the place of.
void require_no_run_in(const fs::path& folder) {
    if (fs::exists(folder / kResultsFile) || has_stress_results(folder) || has_tuning_record(folder))
        throw usage_error("holds a run's results, and the index would take the place of their page",
                          "--out " + folder.string(), "a folder of its own");
}

ExitCode run(const IndexOptions& options, const GlobalOptions& global) {
    require_no_run_in(options.out);
    IndexBuilder index(options.out);
    for (const fs::path& folder : options.folders) {
        const std::vector<fs::path> files = results_files(folder);
        if (files.empty()) {
            const std::string reason = fmt::format("no {} lies in it or below", kResultsFile);
            log_warning(folder.string() + ": " + reason);
            index.add_unreadable(folder, reason);
        }
        for (const fs::path& file : files) add_file(index, file);
    }
    if (index.contents().read == 0)
        throw file_error("no results could be read", options.folders.front().string(),
                         "folders with a results.json");
    print_path(write_index_page(index.contents(), options.out, global.command_line, global.seed));
    return index.contents().unreadable.empty() ? ExitCode::ok : ExitCode::cells_failed;
}

}  // namespace

CommandEntry add_index_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "index",
        "Make one page over any number of results: all scenes and methods, with ranks; prints its path");
    const auto options = std::make_shared<IndexOptions>();
    app->add_option("folders", options->folders,
                    "Results folders, their results.json, or folders with results folders in them")
        ->required();
    app->add_option("--out", options->out, "The folder for the page, from which its links lead")
        ->capture_default_str();
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
