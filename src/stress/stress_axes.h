#pragma once

#include "stress/stress_case.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// One setting of a stress axis: a change of the base case.
struct StressSetting {
    std::string id;     ///< "1e-4": names files
    std::string label;  ///< the value with its unit
    /// Changes the case; empty for the unstressed setting.
    std::function<void(StressCase&)> apply;
    bool unstressed() const { return !apply; }
};

/// The comparison of a stressed result with the unstressed one.
enum class StressJudgement {
    same_picture,  ///< pixel by pixel: exact arithmetic would give the base's picture
    error,         ///< error against the own truth over the base's error: the picture changes
};

/// One kind of stress: a row of the one table. Settings are in order; one of them is the unstressed one.
struct StressAxis {
    std::string_view id;
    std::string_view label;
    std::string_view meaning;  ///< one sentence
    StressJudgement judgement;
    std::vector<StressSetting> settings;
};
const std::vector<StressAxis>& stress_axes();

/// The base case with one setting applied, ready to be drawn and traced.
StressCase stress_case(const StressSetting& setting, int size);

}  // namespace aoscore
