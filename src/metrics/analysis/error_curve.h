#pragma once

#include <cstddef>
#include <vector>

namespace aoscore {

/// The share of the pixels whose error exceeds each of many thresholds: BeyondThreshold::share summed over
/// pixels, at multiples of a step. The share of one pixel is made of straight lines, so that only their bends
/// are noted, as second differences of the sums.
class ErrorCurve {
  public:
    ErrorCurve(double step, std::size_t thresholds) : step_(step), bends_(thresholds) {}

    /// Adds a pixel; its numbers are those of beyond_threshold().
    void add(double error, double standard_error, double most);
    void add(const ErrorCurve& other);

    /// The sums at the thresholds 0, 1, 2, … steps.
    std::vector<double> sums() const;

  private:
    struct Line {
        double value, slope;  ///< at some threshold, and from one to the next
    };
    struct Box {
        double weight, lowest, highest;  ///< adds its weight below `lowest`, nothing above `highest`
        Line at(double threshold) const;
    };

    void add_bend(std::size_t threshold, double bend) {
        if (threshold < bends_.size()) bends_[threshold] += bend;
    }
    /// From this threshold on, a straight line.
    void add_line(std::size_t threshold, Line line);
    /// From here on a slope; the position may lie between thresholds.
    void add_slope(double position, double slope);
    /// A box, up to the threshold `end`.
    void add_box(const Box& box, double end);

    double step_;
    std::vector<double> bends_;
};

}  // namespace aoscore
