#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/folders.h"
#include "core/log.h"
#include "core/output.h"
#include "core/rough_text.h"
#include "store/artifact_store.h"
#include "store/truth/truth_cache.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <memory>

namespace aoscore {
namespace {

struct CacheOptions {
    std::string action;
    std::size_t groups = 4;
};

std::string bytes_text(std::uint64_t bytes) {
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
}

std::string query_text(const TruthQuery& query) {
    std::string text(kFalloffIds[static_cast<std::size_t>(query.falloff)]);
    text += std::isfinite(query.radius_m) ? fmt::format(" {:g} m", query.radius_m) : " endless";
    if (query.falloff == Falloff::alchemy) text += fmt::format(" u {:g} m", query.u_m);
    return text;
}

std::string state_text(const CacheEntry& entry) {
    std::string text = entry.complete
                           ? "complete"
                           : fmt::format("{} of {} parts, to be resumed", entry.groups_done, entry.groups);
    if (entry.damaged_bytes > 0) text += fmt::format(", {} bytes damaged", entry.damaged_bytes);
    if (!entry.current) text += ", of another version: never used";
    return text;
}

std::string name_text(const CacheEntry& entry) {
    return (entry.file.parent_path().filename() / entry.file.filename()).string();
}

void print(const CacheEntry& entry) {
    if (!entry.readable) {
        print_result("{}: unreadable, {}\n", name_text(entry), bytes_text(entry.bytes));
        return;
    }
    std::vector<std::string> queries;
    for (const TruthQuery& query : entry.request.queries) queries.push_back(query_text(query));
    const TruthSettings& settings = entry.request.settings;
    std::string effort = fmt::format("{} samples", settings.samples);
    if (settings.max_error > 0) effort = fmt::format("error {:g}", settings.max_error);
    if (settings.mean_error > 0) effort = fmt::format("mean error {:g}", settings.mean_error);
    std::string extras;
    if (settings.extras.causes) extras += ", causes";
    if (settings.extras.one_layer_bound) extras += ", one-layer bound";
    if (settings.extras.bent_normals) extras += ", bent normals";
    print_result("{} {} {}x{}: {}{}; {}; {}; {} old; {}\n", entry.label.scene, entry.label.view,
                 entry.request.width, entry.request.height, fmt::join(queries, ", "), extras, effort,
                 bytes_text(entry.bytes), rough_duration(entry.age_s), state_text(entry));
}

ArtifactStore measurements() {
    return ArtifactStore(ArtifactStore::folder_in(cache_dir()));
}

ExitCode list(const TruthCache& cache, const CacheOptions&) {
    std::uint64_t bytes = 0;
    const std::vector<CacheEntry> entries = cache.list();
    for (const CacheEntry& entry : entries) {
        print(entry);
        bytes += entry.bytes;
    }
    print_result("{} truths, {}, in {}\n", entries.size(), bytes_text(bytes), cache_dir().string());
    const ArtifactStore::Size size = measurements().size();
    print_result("{} measurements, {}\n", size.entries, bytes_text(size.bytes));
    return ExitCode::ok;
}

ExitCode clear(const TruthCache& cache, const CacheOptions&) {
    const ClearedCache cleared = cache.clear();
    print_result("{} truths removed, {} freed", cleared.files, bytes_text(cleared.bytes));
    if (cleared.kept_in_use > 0) print_result("; {} kept, in use by another process", cleared.kept_in_use);
    const ArtifactStore::Size removed = measurements().clear();
    print_result("\n{} measurements removed, {} freed\n", removed.entries, bytes_text(removed.bytes));
    return ExitCode::ok;
}

ExitCode verify(const TruthCache& cache, const CacheOptions& options) {
    std::size_t bad = 0;
    const std::vector<CacheEntry> entries = cache.list();
    for (const CacheEntry& entry : entries) {
        const CacheVerdict verdict = TruthCache::verify(entry, options.groups);
        const bool good = entry.readable && entry.damaged_bytes == 0 && verdict.groups_differing == 0;
        bad += !good;
        const std::string traced = !verdict.not_traced.empty()
                                       ? "digests only: " + verdict.not_traced
                                       : fmt::format("{} parts traced again, {} differ",
                                                     verdict.groups_compared, verdict.groups_differing);
        print_result("{} {} {}: {} bytes damaged; {}\n", good ? "ok " : "BAD", name_text(entry),
                     entry.readable ? entry.label.scene + " " + entry.label.view : "?", entry.damaged_bytes,
                     traced);
    }
    print_result("{} truths, {} bad\n", entries.size(), bad);
    const std::vector<std::filesystem::path> damaged = measurements().damaged();
    for (const std::filesystem::path& file : damaged) print_result("BAD {}\n", file.string());
    print_result("{} measurements, {} bad\n", measurements().size().entries, damaged.size());
    bad += damaged.size();
    return bad > 0 ? ExitCode::file_error : ExitCode::ok;
}

using Action = ExitCode (*)(const TruthCache&, const CacheOptions&);
const std::map<std::string, Action>& actions() {
    static const std::map<std::string, Action> table{{"list", list}, {"clear", clear}, {"verify", verify}};
    return table;
}

}  // namespace

CommandEntry add_cache_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand("cache",
                                           "The truths and measurements that are kept, in references/cache "
                                           "or the folder that AOSCORE_CACHE names");
    const auto options = std::make_shared<CacheOptions>();
    std::vector<std::string> names;
    for (const auto& [id, action] : actions()) names.push_back(id);
    app->add_option("action", options->action,
                    "list: what there is; verify: check every digest, and trace some tiles of each again to "
                    "compare them bit by bit (exit code 4 when anything is wrong); clear: remove all")
        ->required()
        ->check(one_of(names));
    app->add_option("--parts", options->groups, "For verify: groups of tiles traced again, of each truth")
        ->check(CLI::Range(0, 1 << 20))
        ->capture_default_str();
    return {app, [options] { return actions().at(options->action)(TruthCache(cache_dir()), *options); }};
}

}  // namespace aoscore
