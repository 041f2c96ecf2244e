#pragma once

#include "jobs/recorded/recorded_view.h"

#include <string>
#include <vector>

namespace aoscore {

/// Reads a frame's truth into `view`, whose G-buffer is there: the truth itself, the pixels that count, and
/// the radius. Throws sizes_differ, usage_error where the radius is unknown or another than the file states,
/// and file_error where a pixel that counts is NaN or infinite.
void read_given_truth(const GivenTruthRequest& request, RecordedView& view,
                      std::vector<std::string>& warnings);

}  // namespace aoscore
