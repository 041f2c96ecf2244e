#pragma once

namespace aoscore {

/// The range in which best_fit() searches a parameter.
struct FitRange {
    double least, most;
};
inline constexpr FitRange kFitStrengths{0, 4}, kFitExponents{0.125, 8};

}  // namespace aoscore
