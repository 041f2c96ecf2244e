#pragma once

#include "report/closeness.h"
#include "results/results.h"

#include <filesystem>
#include <map>
#include <string>

namespace aoscore {

/// A PNG as a data URI. Empty when there is no such picture.
struct Picture {
    std::string uri;
    int width = 0, height = 0;
    explicit operator bool() const { return !uri.empty(); }
};

struct ViewPictures {
    Picture truth;
    Picture standard_error;  ///< of the truth, on magma from 0 to standard_error_high
    double standard_error_high = 0;
    Picture depth;  ///< on viridis from depth_low_m to depth_high_m; only where the G-buffer was kept
    double depth_low_m = 0, depth_high_m = 0;
    Picture truth_thumbnail;
};

struct CellPictures {
    Picture output;
    Picture raw;    ///< before the filter; empty without one
    Picture error;  ///< output - truth, on blue_red over ±kErrorRange
    Picture masks;  ///< missing and false occlusion over the truth in gray
    Picture output_thumbnail, raw_thumbnail;
    BlockErrors blocks;
};

/// Ends of the signed-error colours: one range for all methods, so that their pictures can be compared.
inline constexpr double kErrorRange = 0.5;

struct Pictures {
    std::map<std::string, ViewPictures> views;  ///< by ViewRecord::key
    std::map<std::string, CellPictures> cells;  ///< by CellRecord::id; failed cells have none
};

/// Reads the EXR files of the results and encodes every picture of the page, on all threads. Throws
/// file_error where a file or channel is missing, differs in size, or lies outside the folder.
Pictures make_pictures(const Results& results, const std::filesystem::path& folder);

}  // namespace aoscore
