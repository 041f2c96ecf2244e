#pragma once

#include "results/results.h"

#include <filesystem>
#include <set>

namespace aoscore {

/// The pictures of an earlier run in `folder`: what its results.json names below views/ and cells/, relative
/// to the folder. None where no results can be read.
std::set<std::filesystem::path> pictures_in(const std::filesystem::path& folder);

/// Removes those of the earlier run's pictures that `results`, now in the folder, do not name: nothing would
/// say what they show. Files that no results named stay.
void remove_left_pictures(const std::filesystem::path& folder, const std::set<std::filesystem::path>& earlier,
                          const Results& results);

}  // namespace aoscore
