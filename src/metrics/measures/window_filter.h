#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace aoscore {

inline constexpr int kSsimBorder_px = 5;  ///< half of the 11x11 window, a border without values

/// Two rows of an image that follow each other.
using RowPair = std::array<const double*, 2>;

/// Sums under SSIM's window, an 11x11 Gaussian of standard deviation 1.5, row by row: a pushed row is summed
/// across at once, and down when enough rows are there, so that only the last rows are kept. Two rows of sums
/// are computed together, since most of the time goes into reading what is kept. Zhou Wang, Alan Bovik, Hamid
/// Sheikh, Eero Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", 2004.
class WindowFilter {
  public:
    static constexpr std::size_t kRows = 2 * kSsimBorder_px + 2;  ///< read for a pair
    using Rows = std::array<const double*, kRows>;

    /// Makes a filter for rows of `width` values, of which the sums leave out kSsimBorder_px on both sides.
    explicit WindowFilter(std::size_t width)
        : inner_(width - 2 * kSsimBorder_px), kept_(kRows * inner_), sums_(2 * inner_) {}

    void push(const double* row);
    /// The sums around the middle two of the last kRows rows, which must have been pushed.
    RowPair sums();

  private:
    std::size_t inner_, pushed_ = 0;
    std::vector<double> kept_, sums_;
};

}  // namespace aoscore
