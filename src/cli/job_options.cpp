#include "cli/job_options.h"

#include "cli/program.h"
#include "core/log.h"
#include "core/node_kind.h"
#include "core/output.h"
#include "core/processes/shell.h"
#include "jobs/work_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

constexpr const char* kPartsFile = "--parts-file";
constexpr const char* kParts = "--parts";
constexpr const char* kNodeKind = "--node-kind";
constexpr const char* kQuiet = "--quiet";

std::vector<std::string> words_for_parts(const std::filesystem::path& file, std::size_t parts) {
    return {kPartsFile, file.string(), kParts, std::to_string(parts)};
}

/// A command as a user would type it.
std::string command_line_of(const std::vector<std::string>& words) {
    std::string line = "aoscore";
    for (const std::string& word : words) line += " " + shell_quoted(word);
    return line;
}

/// Whether the word is that option, alone or with its value.
bool names(const std::string& word, const std::string& option) {
    return word == option || word.starts_with(option + "=");
}

bool names_node_kind(const std::string& word) {
    return names(word, kNodeKind);
}

/// Throws usage_error where these words choose what the planned command has decided: their jobs would have
/// other keys.
void require_as_planned(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        for (const char* option : {"--seed", "--threads", "--gl"}) {
            if (names(word, option))
                throw usage_error("the command that planned these jobs decides it", option,
                                  fmt::format("no {} here; plan the command with it", option));
        }
    }
}

/// The words, with the kind of node whose times count: whoever makes a job on another machine finds it under
/// the same key.
std::vector<std::string> naming_node_kind(std::vector<std::string> words) {
    if (std::ranges::none_of(words, names_node_kind)) words.insert(words.end(), {kNodeKind, node_kind()});
    return words;
}

/// The kind that naming_node_kind() left in the words: in the option's own word, or in the next.
std::string named_node_kind(const std::vector<std::string>& words) {
    const auto option = std::ranges::find_if(words, names_node_kind);
    if (option == words.end()) return {};
    if (const std::size_t sign = option->find('='); sign != std::string::npos)
        return option->substr(sign + 1);
    return option + 1 == words.end() ? std::string() : *(option + 1);
}

void divide(const JobOptions& options, const nlohmann::json& listing,
            const std::vector<std::string>& arguments) {
    const WorkParts work{.command = PlannedCommand::of(arguments),
                         .times_on = node_kind(),
                         .parts = even_parts(listing, options.parts)};
    write_parts(work, options.parts_file);
    double most_s = 0, all_s = 0;
    std::size_t jobs = 0;
    for (const WorkPart& part : work.parts) {
        most_s = std::max(most_s, part.cost_s);
        all_s += part.cost_s;
        jobs += part.keys.size();
    }
    print_path(options.parts_file);
    if (work.parts.empty()) {
        log_info("Everything is in the cache: there is nothing to do");
        return;
    }
    log_info(fmt::format("{} jobs in {} parts; the largest has {:.1f} times the mean cost", jobs,
                         work.parts.size(),
                         all_s > 0 ? most_s * static_cast<double>(work.parts.size()) / all_s : 1));
    log_info(fmt::format("Times are taken on nodes of kind \"{}\" alone", work.times_on));
}

}  // namespace

void add_job_options(CLI::App& app, JobOptions& options) {
    auto* list =
        app.add_flag("--jobs", options.list,
                     "Print the jobs of this command as JSON, with their keys, and make none of them");
    app.add_option("--job", options.only, "Make the artifact of this key alone, and no page; may be repeated")
        ->excludes(list);
    // Given by the commands plan and work, which users call.
    app.add_option(kPartsFile, options.parts_file)->group("");
    app.add_option(kParts, options.parts)->group("");
}

std::optional<ExitCode> list_or_make_some(
    const JobOptions& options, std::vector<std::string> words,
    const std::function<nlohmann::json(const std::vector<std::string>& words)>& list,
    const std::function<std::size_t(const std::vector<std::string>& keys)>& make) {
    if (options.list) {
        std::erase(words, "--jobs");
        words = naming_node_kind(std::move(words));
        print_result("{}\n", list(words).dump(2));
    } else if (!options.parts_file.empty()) {
        words.resize(words.size() - words_for_parts(options.parts_file, options.parts).size());
        words = naming_node_kind(std::move(words));
        divide(options, list(words), words);
    } else if (!options.only.empty()) {
        return make(options.only) == 0 ? ExitCode::ok : ExitCode::cells_failed;
    } else {
        return std::nullopt;
    }
    return ExitCode::ok;
}

ExitCode run_division(std::vector<std::string> words, const std::filesystem::path& file, std::size_t parts) {
    const std::string line = command_line_of(words);
    const std::vector<std::string> added = words_for_parts(file, parts);
    words.insert(words.end(), added.begin(), added.end());
    return run_words(words, line);
}

ExitCode run_jobs(const PlannedCommand& command, const std::vector<std::string>& keys,
                  const GlobalOptions& given) {
    require_as_planned(given.words);
    std::vector<std::string> words = command.arguments;
    const std::string& node_kind = given.node_kind;
    if (const std::string planned = named_node_kind(words); !node_kind.empty() && node_kind != planned)
        throw usage_error(fmt::format("these jobs' times are those of nodes of kind \"{}\"", planned),
                          fmt::format("{} {}", kNodeKind, node_kind),
                          "no --node-kind; the command that planned them takes another kind");
    const std::string line = command_line_of(words);
    if (given.quiet && std::ranges::find(words, kQuiet) == words.end()) words.emplace_back(kQuiet);
    for (const std::string& file : command.enter())
        log_warning(file + " has changed since the jobs were listed: those that depend on it are others now");
    for (const std::string& key : keys) words.insert(words.end(), {"--job", key});
    return run_words(words, line);
}

}  // namespace aoscore
