#pragma once

#include "results/stress_results.h"

#include <filesystem>
#include <map>
#include <string>

namespace aoscore {

/// The small pictures of one setting below each other, in the order of its cells, as PNG data URIs.
struct StressStrip {
    std::string visibility;     ///< 15 grays; not finite: magenta
    std::string deviation;      ///< blue, white, red over ±kStressDeviationRange; not finite: magenta
    int width = 0, height = 0;  ///< size of one picture
    std::map<std::string, int> places;  ///< by subject, the picture's index from the top
};

/// The largest deviation that colours show.
inline constexpr double kStressDeviationRange = 0.35;

/// Makes the strip of a setting. Throws file_error where the file is missing, lies outside of the folder or
/// lacks a picture.
StressStrip make_stress_strip(const StressSettingRecord& setting, const std::filesystem::path& folder);

}  // namespace aoscore
