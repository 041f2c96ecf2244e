#pragma once

#include "oracle.h"
#include "screen/method/method.h"

#include <functional>
#include <ostream>
#include <vector>

/// Every estimator at high quality with its paper's formula, for any height field seen along -z by an
/// orthographic camera of kSize x kSize pixels, kPixel metres each.
namespace aoscore::testing::formula {

inline constexpr int kSize = 121;

/// A method with the expected mean of its shader over seeds, and the tolerance.
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
