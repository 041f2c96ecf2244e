#pragma once

#include "image/visibility_file.h"
#include "metrics/measures/noise.h"
#include "results/results.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Two images of any program to compare.
struct ComparisonRequest {
    std::filesystem::path truth, test;
    VisibilityReading truth_reading, test_reading;
    std::optional<PixelRect> crop;  ///< part of the truth; a test of this size is taken as cropped
    std::filesystem::path mask;     ///< a further mask of the truth's size; empty: none
    std::string mask_channel;       ///< the mask's channel; empty: find_mask() finds it
    double mask_threshold = 0.1;
    std::uint64_t seed = 1;  ///< seed of the resampling
};

struct Comparison {
    ComparisonRequest request;
    std::string truth_channel, test_channel;
    std::string truth_channel_why, test_channel_why;  ///< how the channels were found, in words
    std::vector<std::string> warnings;                ///< reasons to doubt the numbers, a sentence each
    int width = 0, height = 0;
    ImageF truth, test;  ///< the images compared: turned and cropped
    Mask valid;          ///< pixels compared: within all masks, and finite in both
    std::size_t valid_pixels = 0;
    std::size_t nonfinite = 0;  ///< valid pixels that are NaN or infinite in either image
    MetricMap metrics;
    std::optional<NoiseFloor> noise;        ///< the truth's; empty without its standard error
    std::optional<ErrorAnalysis> analysis;  ///< empty without a valid pixel

    /// Whether there were pixels to compare, and all of them finite.
    bool sound() const { return valid_pixels > 0 && nonfinite == 0; }
};

/// Compares the images. Throws sizes_differ, file_error, and usage_error for a crop outside of the truth.
Comparison compare_images(const ComparisonRequest& request);

nlohmann::json to_json(const Comparison& comparison);

}  // namespace aoscore
