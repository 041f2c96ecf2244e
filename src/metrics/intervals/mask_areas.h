#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace aoscore {

struct DrawnSums;
struct ErrorAnalysis;

inline constexpr const char* kMissingArea = "missing_area";
inline constexpr const char* kFalseArea = "false_area";

/// The share of the valid pixels that an occlusion mask covers. It is ranked over views, limited and shown
/// beside the metrics, by its id.
struct MaskArea {
    std::string_view id;       ///< command line, JSON key
    std::string_view mean_id;  ///< of the mean error within the mask
    std::string_view label;    ///< a column's; with " occlusion" behind it in a sentence
    std::string_view side;     ///< what the mask's pixels are against the truth: "brighter", "darker"
    double (*value)(const ErrorAnalysis&);
    std::optional<double> (*mean)(const ErrorAnalysis&);
    double (*resampled)(const DrawnSums&);  ///< see Metric::resampled
};

/// Missing, then false occlusion.
const std::array<MaskArea, 2>& mask_areas();

}  // namespace aoscore
