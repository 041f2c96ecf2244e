#pragma once

#include "core/error.h"
#include "results/results.h"
#include "verdict/gate.h"

#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The word among limits for "significantly worse than the baseline".
inline constexpr const char* kWorse = "worse";

/// The limits of --fail and --warn.
class Gates {
  public:
    /// Throws usage_error for a malformed limit, an unknown metric, and kWorse without a baseline.
    Gates(const std::vector<std::string>& fail, const std::vector<std::string>& warn, bool has_baseline);

    bool empty() const { return fail_.empty() && warn_.empty(); }

    /// Throws usage_error where a limit lies below the value that the truth's noise alone gives the metric: a
    /// perfect image would trip it. (Metrics that are without_noise may have lower limits: there, noise
    /// averages out.)
    void require_above_noise(double noise_floor_rmse, const std::string& where) const;

    /// One line for each tripped limit: the measured value and the limit that would have passed.
    struct Tripped {
        std::vector<std::string> failures, warnings;
        ExitCode exit_code() const;
        std::size_t count() const { return failures.size() + warnings.size(); }
        void add(const Tripped& other);
    };
    /// Of limited_measures(); `measured_of_some` are the ids that some cell of the run has a value of, see
    /// Gate::judges().
    Tripped check(const MetricMap& measures, const std::set<std::string>& measured_of_some = {}) const;
    /// The texts of the limits that are not held against a cell of these measures.
    std::vector<std::string> not_judging(const MetricMap& measures,
                                         const std::set<std::string>& measured_of_some) const;
    Tripped check(const ChangeRecord& change) const;

  private:
    struct Limits {
        std::vector<Gate> gates;
        bool worse = false;
        bool empty() const { return gates.empty() && !worse; }
    };
    static Limits parse(const std::vector<std::string>& texts, bool has_baseline);

    Limits fail_, warn_;
};

}  // namespace aoscore
