#pragma once

#include "jobs/ground.h"
#include "jobs/view_work.h"
#include "results/results.h"
#include "store/truth/truth_cache.h"

namespace aoscore {

/// The record of a view after its truth was traced and compared with the G-buffer; `described` is the record
/// before that.
ViewRecord recorded_view(const ViewWork& work, const ViewRecord& described, const CachedTruth& traced,
                         const Ground& ground);

}  // namespace aoscore
