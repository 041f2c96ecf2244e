#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace aoscore {

struct DrawnSums;
struct ErrorAnalysis;

inline constexpr const char* kMissingArea = "missing_area";
inline constexpr const char* kFalseArea = "false_area";

/// The share of the valid pixels that miss occlusion, or add some, by more than the mask's threshold, without
/// what the truth's noise adds where its standard error is known (MaskSummary::area). Like a metric, it has
/// an id, is averaged over views, limited and shown.
struct MaskArea {
    std::string_view id;       ///< its name on the command line and in JSON
    std::string_view mean_id;  ///< id of the mean error within the mask
    std::string_view label;    ///< label of a column; followed by " occlusion" in a sentence
    std::string_view side;     ///< the mask's pixels against the truth: "brighter", "darker"
    double (*value)(const ErrorAnalysis&);
    std::optional<double> (*mean)(const ErrorAnalysis&);
    double (*resampled)(const DrawnSums&);  ///< see Metric::resampled
};

/// The areas of missing, then of false occlusion.
const std::array<MaskArea, 2>& mask_areas();

/// Whether this is the id of the mean error within a mask. Tables of scores do not show it, and so no rays
/// are traced for it.
bool is_mean_of_mask(std::string_view id);

}  // namespace aoscore
