#pragma once

#include "jobs/ground.h"
#include "jobs/view_work.h"
#include "results/results.h"
#include "store/truth/truth_cache.h"

namespace aoscore {

/// What the results say of a view once its truth is traced and held against the G-buffer; `described` is what
/// was known before.
ViewRecord recorded_view(const ViewWork& work, const ViewRecord& described, const CachedTruth& traced,
                         const Ground& ground);

}  // namespace aoscore
