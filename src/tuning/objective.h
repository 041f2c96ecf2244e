#pragma once

#include "metrics/metric.h"
#include "plan/plan.h"
#include "plan/resolved_cell.h"
#include "screen/screen.h"
#include "store/artifact_store.h"
#include "tuning/search_axis.h"
#include "tuning/tuning_views.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// What is tuned, and against what. Objects that it refers to must outlive it.
struct TuningSubject {
    CellPlan cell;  ///< the method with the preset to begin from, its filter and modes
    std::vector<SearchAxis> axes;
    std::string metric;  ///< id of the metric that decides
    std::uint64_t seed = 1;
};

/// Throws usage_error, which lists the others, for a metric that has no value for the truth itself: no loss
/// can be related to its best value.
void require_best_value(const Metric& metric);

/// Measures a method's settings on views: a metric of its picture, and the fetches a pixel. Every measurement
/// is made once; the store keeps it, so that a search that was stopped goes on where it was. Settings are
/// values of the axes at the reference radius, in the order of the axes.
class Objective {
  public:
    /// All arguments must outlive this object.
    Objective(const TuningSubject& subject, const Registry& registry,
              const std::vector<std::unique_ptr<TuningView>>& views, ScreenRenderer& renderer,
              const ArtifactStore& store);

    /// How far the metric is from its best value on a view: the value itself where lower is better, what is
    /// missing of 1 where higher is, and its magnitude where nearer zero is.
    double loss(const std::vector<double>& settings, std::size_t view);
    /// The metric's mean over views, from their losses (Metric::over_views).
    double loss_over(const std::vector<double>& settings, const std::vector<std::size_t>& views);
    /// Fetches a pixel of the AO passes, the mean over the first view's valid pixels.
    double fetches(const std::vector<double>& settings);
    /// Milliseconds of the AO passes and the filter on the first view, on this machine:
    /// the median of runs in turns with the fixed pass, which stands for the speed that the machine has just
    /// then. Measured once for each combination of whole numbers, with all else as in the preset. Throws
    /// cells_failed where it cannot be timed.
    double milliseconds(const std::vector<double>& settings);

    /// Images that were drawn now, and those that were measured before.
    std::size_t drawn() const { return drawn_; }
    std::size_t reused() const { return reused_; }

    /// The values of the preset.
    std::vector<double> published() const;

  private:
    MethodRequest request_on(const std::vector<double>& settings, std::size_t view) const;
    double measured_loss(const MethodRequest& request, std::size_t view);
    template <class Measure>
    double stored(const std::string& kind, const MethodRequest& request, std::size_t view,
                  const Measure& measure);

    /// Times the preset with its whole numbers as in the settings: milliseconds, and those of the fixed pass.
    std::pair<double, double> timed(const std::vector<double>& settings);
    double timed_in_passes(const std::vector<double>& settings);

    const TuningSubject& subject_;
    const Metric& metric_;
    const MethodDescriptor& fixed_pass_;
    const std::vector<std::unique_ptr<TuningView>>& views_;
    ScreenRenderer& renderer_;
    const ArtifactStore& store_;
    std::vector<ResolvedCell> cells_;  ///< the preset on each view
    std::map<std::pair<std::vector<double>, std::size_t>, double> losses_;
    std::map<std::vector<double>, double> fetches_;
    std::map<std::vector<double>, double> passes_;  ///< times in fixed passes, by settings
    double fixed_pass_ms_ = 0;                      ///< 0: not timed yet
    std::size_t drawn_ = 0, reused_ = 0;
};

}  // namespace aoscore
