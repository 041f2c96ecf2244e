#pragma once

#include "oracle.h"
#include "screen/method/method.h"

#include <functional>
#include <ostream>
#include <vector>

/// Every estimator at high quality, with what its paper's formula gives: for any height field that is seen
/// along -z by an orthographic camera of kSize x kSize pixels, kPixel metres each.
namespace aoscore::testing::formula {

inline constexpr int kSize = 121;

/// A method, what its shader's mean over seeds must be, and how near.
struct Case {
    const char* name;
    const char* method;
    ParameterValues settings;
    std::function<double(const oracle::Field&, const oracle::Point&)> expected;
    double tolerance;
    int seeds;
};
void PrintTo(const Case& c, std::ostream* out);

const std::vector<Case>& cases();

}  // namespace aoscore::testing::formula
