#pragma once

#include "cli/job_options.h"
#include "results/export/export_files.h"
#include "results/results.h"
#include "verdict/gates.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Options for the outcome of a run: its exit code and files.
struct OutcomeOptions {
    std::vector<std::string> fail, warn;
    std::vector<std::filesystem::path> exports;
    std::filesystem::path baseline;  ///< empty: none
    JobOptions jobs;
};
/// Adds --fail, --warn and --export.
void add_outcome_options(CLI::App& app, OutcomeOptions& options);
/// Adds --baseline.
void add_baseline_option(CLI::App& app, OutcomeOptions& options);

/// Gates, open export files and the baseline, made before the work begins, so that a fault in them costs
/// nothing.
class Outcome {
  public:
    explicit Outcome(const OutcomeOptions& options);

    const Gates& gates() const { return gates_; }
    ExportFiles& exports() { return exports_; }
    const std::shared_ptr<const Results>& baseline() const { return baseline_; }

    /// Writes the exports of a run, says on standard error which limits were tripped where, and returns the
    /// exit code: a tripped --fail or a view on which nothing can be compared, then a failed cell, then a
    /// tripped --warn. A cell that failed has no value and so trips every limit. Where there are views or
    /// limits and not one cell it writes no export, and throws Error with ExitCode::gate_failed.
    ExitCode conclude(const Results& results);

    /// Prints the limits that were tripped.
    static void print(const Gates::Tripped& tripped, const std::string& where);
    /// Prints the number of tripped limits in one line, where there are several; `where` such as " in 3 of 8
    /// cells".
    static void print_summary(const Gates::Tripped& tripped, const std::string& where = {});

  private:
    std::shared_ptr<const Results> baseline_;
    Gates gates_;
    ExportFiles exports_;
};

}  // namespace aoscore
