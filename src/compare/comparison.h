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

/// Two images of any program, to be held against each other.
struct ComparisonRequest {
    std::filesystem::path truth, test;
    VisibilityReading truth_reading, test_reading;
    std::optional<PixelRect> crop;  ///< of the truth; a test of this size is taken to be cropped already
    std::filesystem::path mask;     ///< of the truth's size, beside the masks of the files; empty: none
    std::string mask_channel;       ///< of the mask; empty: found
    double mask_threshold = 0.1;
    std::uint64_t seed = 1;  ///< of the resampling
};

struct Comparison {
    ComparisonRequest request;
    std::string truth_channel, test_channel;
    std::string truth_channel_why, test_channel_why;  ///< how they were found, in words
    std::vector<std::string> warnings;                ///< what makes the numbers doubtful, a sentence each
    int width = 0, height = 0;
    ImageF truth, test;  ///< as they were compared: read, turned, cropped
    Mask valid;          ///< what was compared: within all masks, and finite in both
    std::size_t valid_pixels = 0;
    std::size_t nonfinite = 0;  ///< valid pixels that are NaN or infinite in either image
    MetricMap metrics;
    std::optional<NoiseFloor> noise;        ///< of the truth; empty where its standard error is not known
    std::optional<ErrorAnalysis> analysis;  ///< empty without a valid pixel

    /// Whether there was anything to compare, and all of it was numbers.
    bool sound() const { return valid_pixels > 0 && nonfinite == 0; }
};

/// Throws sizes_differ, file_error, and usage_error for a crop outside of the truth.
Comparison compare_images(const ComparisonRequest& request);

nlohmann::json to_json(const Comparison& comparison);

}  // namespace aoscore
