#include "core/pace.h"

#include <algorithm>

namespace aoscore {
namespace {

constexpr double kKept = 0.5;  ///< of earlier observations' weight
/// The guess weighs as much as one observation of size 0.1, and as its slope seen over a size of 0.1.
constexpr double kGuess = 0.1;

}  // namespace

void Pace::observe(double size, double took_s) {
    for (double* sum : {&count, &sizes, &squares, &seconds, &products}) *sum *= kKept;
    count += 1;
    sizes += size;
    squares += size * size;
    seconds += took_s;
    products += size * took_s;
}

// The normal equations of fixed_s and unit_s, with the guess as two more observations.
double Pace::predicted_s(double size) const {
    constexpr double kWeight = kGuess * kGuess;
    const double a = count + kWeight, b = sizes, d = squares + kWeight;
    const double right = seconds + kWeight * fixed_s, below = products + kWeight * unit_s;
    const double determinant = a * d - b * b;
    const double fixed = (right * d - b * below) / determinant, unit = (a * below - b * right) / determinant;
    if (unit < 0) return std::max(right / a, 0.0);          // times that do not grow with the size
    if (fixed < 0) return std::max(below / d, 0.0) * size;  // nor is any work done before it begins
    return fixed + unit * size;
}

}  // namespace aoscore
