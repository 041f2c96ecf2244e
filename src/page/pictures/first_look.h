#pragma once

#include "metrics/analysis/regions.h"
#include "results/results.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The range of signed error, up and down, that the first screen's pictures show.
inline constexpr double kFirstLookRange = 0.5;

/// A view at a glance: PNGs that a browser shows without a script.
struct FirstLook {
    std::string view_key;
    std::string cell_id;               ///< the method that is shown; empty where every cell failed
    std::string icon;                  ///< the truth, small
    std::string truth, output, error;  ///< error is output minus truth, blue to red over kFirstLookRange
    std::optional<ErrorRegion> worst;  ///< the region with the largest summed error; empty without any
    int cut_left = 0, cut_top = 0;     ///< what is cut out around its worst pixel
    int cut_width = 0, cut_height = 0;
    std::string worst_truth, worst_output;  ///< the cut-out; empty without a region
};

/// Makes the first looks of all views, on all threads. Each shows the first cell of the view that succeeded,
/// a bound only where there is no other; the results are those of in_ranking_order(). Throws file_error where
/// a file or channel is missing or lies outside the folder.
std::vector<FirstLook> first_looks(const Results& results, const std::filesystem::path& folder);

}  // namespace aoscore
