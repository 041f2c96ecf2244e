#pragma once

#include "results/results.h"

#include <filesystem>

namespace aoscore::testing {

/// Results like those of a run of three methods on two views, with small synthetic pictures: the truth is a
/// soft gradient with dark creases, and the methods are the truth with a shift, smoothing or noise. The
/// tables are the definitions in reports/. One cell, atrium/close/alchemy/performance-close, failed.
///
/// Debiased RMSE on atrium/wide, performance: alchemy .05, hbao-hussain .08, crytek-ssao .2.
Results synthetic_results();

/// The same results without the images of views and cells.
Results without_pictures(Results results);

/// Writes the results and their images.
void write_synthetic(const Results& results, const std::filesystem::path& folder);

}  // namespace aoscore::testing
