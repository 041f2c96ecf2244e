#pragma once

#include "results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One setting of a sweep with what a reader compares: what its table, its curves and its CSV show.
struct SweepRow {
    const SweepPointRecord* point = nullptr;
    const CellRecord* cell = nullptr;                 ///< over several views: the first one's, for its names
    const ViewRecord* view = nullptr;                 ///< null over several views
    std::optional<double> cost_ms;                    ///< median of the AO pass with its filter
    std::optional<double> cost_low_ms, cost_high_ms;  ///< the interval of its median; empty with too few runs
    std::optional<double> relative_cost;              ///< to the view's fixed pass of sixteen fetches
    std::optional<FrameRecord> frame;                 ///< with its lighting, where that was timed
    std::optional<double> fetches;                    ///< a pixel, of the AO pass
    std::optional<double> error;                      ///< debiased RMSE
    std::optional<double> noisy_error;                ///< RMSE, the truth's noise included
    std::optional<double> fitted_error;      ///< debiased RMSE after the best fit of strength and exponent
    std::optional<double> unfiltered_error;  ///< debiased RMSE before the filter
    std::optional<double> bias;
    bool on_front = false;              ///< of cost and error among the rows of its view; never a bound
    std::optional<bool> within_budget;  ///< empty without a budget
};

/// The rows in the sweep's order. Throws file_error where it names a cell or view that the results lack.
std::vector<SweepRow> sweep_rows(const Results& results, const SweepRecord& sweep);

/// Rows over a group of views, two or more.
struct SweepRowsOverViews {
    std::vector<const ViewRecord*> views;
    std::vector<SweepRow> rows;
};

/// For each group of comparable_views() of the sweep the settings that were measured in every one of them,
/// each as one row: errors and bias as rankings have them, by measure_over_views(); costs and fetches as
/// means over views (the ends of their intervals too, which is wider than the interval of the
/// mean). The front is that of these rows. Groups of one view, and those without such a setting, are left
/// out.
std::vector<SweepRowsOverViews> rows_over_views(const std::vector<SweepRow>& rows);

/// "samples 8, radius 0.5": where a point lies on the axes, without its method.
std::string point_text(const SweepPointRecord& point);

/// All sweeps as comma-separated values with one head line; RFC 4180.
std::string sweeps_as_csv(const Results& results);

}  // namespace aoscore
