#pragma once

#include "results/stress_results.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// What a stress test covers.
struct StressPlan {
    std::vector<std::string> methods;  ///< empty: all
    std::vector<std::string> axes;     ///< empty: all
    std::filesystem::path methods_dir;
    int size = 256;          ///< of the base picture, pixels a side
    int samples = 64;        ///< rays a pixel
    bool ends_only = false;  ///< of each axis the unstressed and the outermost settings alone
    std::uint64_t seed = 1;
    std::filesystem::path cache;  ///< where artifacts are kept; empty: nowhere
    std::string command;
};

/// Runs every subject at every setting, one axis at a time. What the cache has is taken from there; all else
/// is put there as soon as it is made. stress.json is written at the end, with the settings' images beside
/// it. Throws usage_error for an unknown method or axis before anything is written; interrupted_error on
/// Ctrl-C, after which the same call goes on where it stopped.
StressResults run_stress(const StressPlan& plan, const std::filesystem::path& folder);

/// Cells that could not be run.
std::size_t failed_cells(const StressResults& results);

}  // namespace aoscore
