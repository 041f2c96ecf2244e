#include "cli/outcome_options.h"

#include "core/log.h"
#include "experiment/experiment.h"
#include "jobs/camera_contract.h"
#include "results/baseline_scope.h"
#include "verdict/baseline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

namespace aoscore {
namespace {

std::shared_ptr<const Results> read_baseline(const std::filesystem::path& path) {
    return path.empty() ? nullptr : std::make_shared<const Results>(read_results(path));
}

double noise_floor_of(const Results& results, const CellRecord& cell) {
    for (const ViewRecord& view : results.views) {
        if (view.key == cell.view_key && !view.truths.empty()) return view.truths.front().noise_floor_rmse;
    }
    return 0;
}

/// Refuses results without a single cell where there are views, such as a frame that holds what none of the
/// methods reads, or limits: a gate would pass though nothing was held to it.
void require_cells(const Results& results, const Gates& gates) {
    if (!results.cells.empty() || (results.views.empty() && gates.empty())) return;
    throw Error(ExitCode::gate_failed, "no method was scored: nothing could be compared",
                results.views.empty() ? "" : results.views.front().key,
                "a view and methods that it has everything for");
}

/// The measures that at least one cell has a value of.
std::set<std::string> measured_of_some(const Results& results) {
    std::set<std::string> ids;
    for (const CellRecord& cell : results.cells) {
        for (const auto& [id, measure] : limited_measures(cell)) {
            if (measure.value) ids.insert(id);
        }
    }
    return ids;
}

/// Says which limits are not held against which cells, since their methods do not give the signal.
void print_not_judged(const std::map<std::string, std::vector<std::string>>& cells_by_limit) {
    for (const auto& [limit, cells] : cells_by_limit) {
        log_error(fmt::format("{} is not held against {}: no such signal is given there", limit,
                              fmt::join(cells, ", ")));
    }
}

}  // namespace

void add_outcome_options(CLI::App& app, OutcomeOptions& options) {
    std::vector<std::string_view> extensions;
    for (const ExportFormat& format : export_formats()) extensions.push_back(format.extension);
    app.add_option(
           "--fail", options.fail,
           "Exit with 2 when this holds: rmse>0.02 (also without a value, but for signals that a method "
           "does not give); may be repeated")
        ->allow_extra_args(false);
    app.add_option("--warn", options.warn, "Exit with 1 when this holds: ssim<0.9")->allow_extra_args(false);
    app.add_option(
           "--export", options.exports,
           fmt::format("Write the numbers to this file, by its extension: {}", fmt::join(extensions, ", ")))
        ->allow_extra_args(false);
}

void add_baseline_option(CLI::App& app, OutcomeOptions& options) {
    app.add_option(
        "--baseline", options.baseline,
        "results.json of an earlier run: says of each cell whether it is better or worse beyond doubt; "
        "--fail worse makes that a limit");
}

Outcome::Outcome(const OutcomeOptions& options)
    : baseline_(read_baseline(options.baseline)),
      gates_(options.fail, options.warn, baseline_ != nullptr),
      exports_(options.exports) {}

void Outcome::print(const Gates::Tripped& tripped, const std::string& where) {
    for (const std::string& line : tripped.failures) log_error(fmt::format("fail {}: {}", where, line));
    for (const std::string& line : tripped.warnings) log_error(fmt::format("warn {}: {}", where, line));
}

void Outcome::print_summary(const Gates::Tripped& tripped, const std::string& where) {
    if (tripped.count() < 2) return;
    log_error(fmt::format("{} limits of --fail and {} of --warn tripped{}", tripped.failures.size(),
                          tripped.warnings.size(), where));
}

ExitCode Outcome::conclude(const Results& results) {
    require_cells(results, gates_);
    std::map<std::string, Gates::Tripped> by_cell;
    const std::set<std::string> measured = measured_of_some(results);
    std::map<std::string, std::vector<std::string>> not_judged;
    for (const CellRecord& cell : results.cells) {
        const MetricMap measures = limited_measures(cell);
        // What failed cannot be told from what a method does not give.
        const std::set<std::string> elsewhere = cell.error.empty() ? measured : std::set<std::string>();
        by_cell[cell.id] = gates_.check(measures, elsewhere);
        for (const std::string& limit : gates_.not_judging(measures, elsewhere))
            not_judged[limit].push_back(cell.id);
    }
    print_not_judged(not_judged);
    if (results.baseline) {
        log_info("Baseline: " + baseline_scope(results));
        if (const std::string text = baseline_ ? other_truths(results, *baseline_) : ""; !text.empty())
            log_warning(text);
        for (const ChangeRecord& change : results.baseline->changes)
            by_cell[change.cell_id].add(gates_.check(change));
    }
    Gates::Tripped all;
    std::size_t cells_tripped = 0;
    std::map<std::string, std::vector<std::string>> failures;
    for (const auto& [id, tripped] : by_cell) {
        print(tripped, id);
        all.add(tripped);
        cells_tripped += tripped.count() > 0 ? 1 : 0;
        if (!tripped.failures.empty()) failures[id] = tripped.failures;
    }
    print_summary(all, fmt::format(" in {} of {} cells", cells_tripped, by_cell.size()));
    exports_.write(export_table(results, failures));
    for (const CellRecord& cell : results.cells)
        gates_.require_above_noise(noise_floor_of(results, cell), cell.view_key);
    bool comparable = true;
    for (const ViewRecord& view : results.views) {
        const std::string reason = emptiness(view.surface_pixels, view.valid_pixels);
        if (reason.empty()) continue;
        comparable = false;
        log_error(fmt::format("fail {}: {}", view.key, reason));
    }
    if (!all.failures.empty() || !comparable) return ExitCode::gate_failed;
    return failed_cells(results) > 0 ? ExitCode::cells_failed : all.exit_code();
}

}  // namespace aoscore
