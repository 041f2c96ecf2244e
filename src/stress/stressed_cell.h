#pragma once

#include "core/image.h"
#include "jobs/view_maker.h"
#include "results/stress_results.h"
#include "stress/stress_judge.h"
#include "stress/stress_work.h"

#include <filesystem>

namespace aoscore {

/// A picture that the maker has just made of the work's view, and what is known about it.
StressedPicture stressed_picture(const StressWork& work, const StressRequest& request,
                                 const ViewMaker& maker);

/// What is kept of one subject on a stressed view: numbers, and thumbnails of its picture and of the
/// difference that its deviation is made of, which is empty where that is not.
struct StressedCell {
    StressCell cell;
    ImageF picture, difference;
};
/// An EXR: `Y` the picture, `D` the difference, and the numbers in its header.
void write_stressed_cell(const std::filesystem::path& path, const StressedCell& cell);
/// Throws file_error for a file of another form.
StressedCell read_stressed_cell(const std::filesystem::path& path);

}  // namespace aoscore
