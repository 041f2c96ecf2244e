#include "metrics/analysis/error_curve.h"

#include "metrics/analysis/beyond_threshold.h"
#include "metrics/intervals/block_grid.h"

#include <cmath>
#include <limits>

namespace aoscore {
namespace {

/// A box that is narrower than so many steps has no width.
constexpr double kNarrowest = 1e-4;

}  // namespace

ErrorCurve::Line ErrorCurve::Box::at(double threshold) const {
    if (threshold <= lowest) return {weight, 0};
    if (threshold > highest) return {0, 0};
    const double slope = -weight / (highest - lowest);
    return {weight + slope * (threshold - lowest), slope};
}

void ErrorCurve::add_line(std::size_t threshold, Line line) {
    add_bend(threshold, line.value);
    add_bend(threshold + 1, line.slope - line.value);
}

void ErrorCurve::add_slope(double position, double slope) {
    const double below = std::floor(position), beyond = position - below;
    const auto next = static_cast<std::size_t>(below) + 1;
    add_bend(next, slope * (1 - beyond));
    add_bend(next + 1, slope * beyond);
}

void ErrorCurve::add_box(const Box& box, double end) {
    if (box.highest <= 0) return;
    const double slope = -box.weight / (box.highest - box.lowest);
    add_line(0, box.at(0));
    if (box.lowest >= 0 && box.lowest < end) add_slope(box.lowest, slope);
    if (box.highest < end) add_slope(box.highest, -slope);
    if (std::isinf(end)) return;
    const Line rest = box.at(end);
    add_line(static_cast<std::size_t>(end), {-rest.value, -rest.slope});
}

void ErrorCurve::add(double error, double standard_error, double most) {
    const double reach = boxes::kWideReach * standard_error;
    if (error + reach <= 0 || most <= 0) return;
    if (reach < kNarrowest * step_) {
        if (error <= 0) return;
        add_line(0, {1, 0});
        add_line(static_cast<std::size_t>(std::ceil(error / step_)), {-1, 0});
        return;
    }
    // No truth can be beyond `most`.
    const double end =
        error + reach > most ? std::ceil(most / step_) : std::numeric_limits<double>::infinity();
    const double narrow = boxes::kNarrowReach * standard_error;
    add_box({boxes::kWideWeight, (error - reach) / step_, (error + reach) / step_}, end);
    add_box({boxes::kNarrowWeight, (error - narrow) / step_, (error + narrow) / step_}, end);
}

void ErrorCurve::add(const ErrorCurve& other) {
    add_sums(bends_, other.bends_);
}

std::vector<double> ErrorCurve::sums() const {
    std::vector<double> sums;
    double sum = 0, rise = 0;
    for (const double bend : bends_) {
        rise += bend;
        sum += rise;
        sums.push_back(sum);
    }
    return sums;
}

}  // namespace aoscore
