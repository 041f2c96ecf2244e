#pragma once

#include "core/image.h"
#include "results/results.h"

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// One of two images that were compared.
struct ComparedImage {
    std::string file;
    std::string channel;
    std::string why;  ///< how the channel was found, in words
    ImageF visibility;
};

/// The contents of the page of one comparison.
struct ComparisonPage {
    std::string command;
    ComparedImage truth, test;  ///< both have one size
    Mask valid;                 ///< the pixels compared
    std::vector<std::string> warnings, failures;
    MetricMap metrics;
    std::optional<ErrorAnalysis> analysis;  ///< empty where nothing could be compared
    std::optional<double> noise_floor_rmse;
};

/// Writes one self-contained HTML page: the error in a sentence, the channels with the reason for each,
/// warnings, every metric with its interval, and both pictures beside the signed error. Pictures are at most
/// 1200 pixels wide, each pixel being the mean of those it covers. Throws file_error where it cannot be
/// written.
void write_comparison_page(const std::filesystem::path& path, const ComparisonPage& comparison);

}  // namespace aoscore
