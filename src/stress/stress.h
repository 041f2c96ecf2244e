#pragma once

#include "results/stress_results.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// The extent of a stress test.
struct StressPlan {
    std::vector<std::string> methods;  ///< empty: all
    std::vector<std::string> axes;     ///< empty: all
    std::filesystem::path methods_dir;
    int size = 256;          ///< side of the base picture in pixels
    int samples = 64;        ///< rays a pixel
    bool ends_only = false;  ///< only the unstressed and the outermost settings of each axis
    std::uint64_t seed = 1;
    std::filesystem::path cache;  ///< folder for artifacts; empty: none are kept
    std::string command;
};

/// Runs every subject at every setting, one axis at a time. Artifacts are taken from the cache, or put there
/// as soon as they are made. stress.json is written at the end, with the settings' images beside it. Throws
/// usage_error for an unknown method or axis before anything is written; interrupted_error on Ctrl-C, after
/// which the same call goes on where it stopped.
StressResults run_stress(const StressPlan& plan, const std::filesystem::path& folder);

/// The number of cells that failed.
std::size_t failed_cells(const StressResults& results);

}  // namespace aoscore
