#pragma once

#include "jobs/ground.h"
#include "jobs/view_work.h"
#include "store/truth/truth_cache.h"

namespace aoscore {

// The image files of a view, below its work's folder.

void write_truth_file(const ViewWork& work, const CachedTruth& traced, const Ground& ground);
void write_gbuffer_file(const ViewWork& work, const GBufferImages& gbuffer);
/// `Y` the output, and `raw.Y` what it was before its filter, where it has one; beside them the channels
/// of the signals that it gives (see core/signal.h).
void write_image_file(const ViewWork& work, const CellWork& cell, const MethodOutput& image);

}  // namespace aoscore
