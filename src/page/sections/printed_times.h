#pragma once

#include "results/sweep_rows.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace aoscore {

/// The model of the times that a sweep's source prints of settings of one view, beside this run's: each as a
/// part of the first row's, since machines differ; with what each setting was measured to find. `rows` are
/// the view's. No rows where the source prints nothing of the view.
nlohmann::json printed_times(const SweepRecord& sweep, const std::vector<const SweepRow*>& rows);

}  // namespace aoscore
