#pragma once

#include "core/image.h"
#include "jobs/view_maker.h"
#include "results/stress_results.h"
#include "stress/stress_judge.h"
#include "stress/stress_work.h"

#include <filesystem>

namespace aoscore {

/// The picture that the maker has just made of the work's view, with the data by which it is judged.
StressedPicture stressed_picture(const StressWork& work, const StressRequest& request,
                                 const ViewMaker& maker);

/// The stored result of one subject on a stressed view: its numbers, and thumbnails of its picture and of the
/// difference behind its deviation, where there is one.
struct StressedCell {
    StressCell cell;
    ImageF picture, difference;
};
/// Writes an EXR with the picture in `Y`, the difference in `D`, and the numbers in its header.
void write_stressed_cell(const std::filesystem::path& path, const StressedCell& cell);
/// Reads such a file. Throws file_error for one of another form.
StressedCell read_stressed_cell(const std::filesystem::path& path);

}  // namespace aoscore
