#pragma once

#include "results/results.h"

#include <filesystem>

namespace aoscore::testing {

/// Results as a run of three methods on two views leaves them, with small synthetic pictures: a soft gradient
/// with dark creases as truth; methods that are the truth with a shift, a blur or noise of their own. The
/// tables are the definitions in reports/. One cell, atrium/close/alchemy/performance-close, failed.
///
/// Ranked by debiased RMSE on atrium/wide, performance: alchemy .05, hbao-hussain .08, crytek-ssao .2.
Results synthetic_results();

/// Writes them and their images.
void write_synthetic(const Results& results, const std::filesystem::path& folder);

}  // namespace aoscore::testing
