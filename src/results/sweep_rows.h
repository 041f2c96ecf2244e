#pragma once

#include "results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One setting of a sweep with the numbers that its table, its curves and its CSV show.
struct SweepRow {
    const SweepPointRecord* point = nullptr;
    const CellRecord* cell = nullptr;                 ///< over several views the first one's, for its names
    const ViewRecord* view = nullptr;                 ///< null over several views
    std::optional<double> cost_ms;                    ///< median of the AO pass with its filter
    std::optional<double> cost_low_ms, cost_high_ms;  ///< interval of the median; empty with too few runs
    std::optional<double> relative_cost;              ///< cost over the view's fixed pass of sixteen fetches
    std::optional<FrameRecord> frame;                 ///< set where lighting was timed
    std::optional<double> fetches;                    ///< fetches a pixel by the AO pass
    std::optional<double> error;                      ///< debiased RMSE
    std::optional<double> noisy_error;                ///< RMSE, the truth's noise included
    std::optional<double> fitted_error;      ///< debiased RMSE after the best fit of strength and exponent
    std::optional<double> unfiltered_error;  ///< debiased RMSE before the filter
    std::optional<double> bias;
    /// The part that is shown of the occlusion that one depth layer cannot know (found_beyond_layer()); empty
    /// where that was not traced.
    std::optional<double> beyond_layer;
    /// The parts of what the first layer hides that are found at the fitted strength, of what the estimator
    /// finds over all layers and of the truth's; and the noise over seeds at that strength. Empty where the
    /// setting was not drawn again.
    std::optional<double> found_of_layers, found_of_truth, noise;
    bool on_front = false;              ///< on the front of cost and error of its view; never a bound
    std::optional<bool> within_budget;  ///< empty without a budget
};

/// The rows in the sweep's order. Throws file_error where it names a cell or view that the results lack.
std::vector<SweepRow> sweep_rows(const Results& results, const SweepRecord& sweep);

/// The rows over a group of two or more views.
struct SweepRowsOverViews {
    std::vector<const ViewRecord*> views;
    std::vector<SweepRow> rows;
};

/// Makes, for each group of comparable_views() of the sweep, one row for each setting that was measured on
/// all of its views. Errors and bias are by measure_over_views(), as in rankings; costs and fetches are means
/// over views, as are the ends of their intervals, which is wider than the interval of the mean. The front is
/// that of these rows. Groups of one view, and those without such a setting, are left out.
std::vector<SweepRowsOverViews> rows_over_views(const std::vector<SweepRow>& rows);

/// A point's values on the axes, without its method: "samples 8, radius 0.5".
std::string point_text(const SweepPointRecord& point);

/// All sweeps as comma-separated values with one header line (RFC 4180).
std::string sweeps_as_csv(const Results& results);

}  // namespace aoscore
