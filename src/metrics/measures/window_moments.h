#pragma once

#include "core/image.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/pixel_weights.h"
#include "metrics/measures/window_filter.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace aoscore {

/// Mean and variance of an image under SSIM's window, around each pixel that is kSsimBorder_px or more
/// inside; the planes are smaller than the image by that on each side.
struct WindowMoments {
    Image<double> mean, variance;
};

/// The moments are normalised convolutions: pixels of weight 0, which may be NaN, contribute nothing. Hans
/// Knutsson, Carl-Fredrik Westin, "Normalized and Differential Convolution", 1993. The image must be larger
/// than the window.
WindowMoments window_moments(const ImageF& image, const PixelWeights& weights);

/// The areas in which pixels with a window are filtered, of an image of this size. The window of an area's
/// pixel x, y covers the image from x, y to x + 2 * kSsimBorder_px, y + 2 * kSsimBorder_px.
std::vector<ImageArea> windowed_areas(int image_width, int image_height);

/// The weights under the windows of an area, row by row.
class MovingWeights {
  public:
    /// `weights` must outlive it.
    MovingWeights(const PixelWeights& weights, const ImageArea& area);

    /// Pushes the weights of row `y`, which must be the one after the last.
    const std::vector<double>& push(int y);
    /// The factors that make a mean of a weighted sum around the middle two of the last rows: 1 where all
    /// pixels count fully, and infinite where none counts.
    RowPair scales();

  private:
    const PixelWeights& weights_;
    int left_;
    WindowFilter filter_;
    std::vector<double> row_, scales_;  ///< scales of two rows
};

/// A row of WindowMoments.
struct MomentRow {
    const double *mean, *variance;
};

/// Two of them that follow each other.
using MomentRows = std::array<MomentRow, 2>;

/// The moments under the windows of an area, row by row.
class MovingMoments {
  public:
    /// Makes it for rows of `width` pixels that are read.
    explicit MovingMoments(std::size_t width);

    /// Pushes the next row: its values, 0 where they do not count, and their weights.
    void push(const std::vector<double>& values, const std::vector<double>& weights);
    /// The moments around the middle two of the last rows pushed, by MovingWeights' scales.
    MomentRows rows(const RowPair& scales);

  private:
    WindowFilter values_, squares_;
    std::vector<double> terms_, squared_terms_;
    std::vector<double> mean_, variance_;  ///< of two rows
};

/// Calls push(y) for every row that the windows of an area cover, and pair(y) for the first of every two rows
/// with a window, counted from the first inside the border, as soon as the rows for both were pushed. Where
/// the area has an odd number of rows, the last one is pushed twice, and the second row of the last pair
/// means nothing.
template <class Push, class Pair>
void for_each_pair(const ImageArea& area, Push push, Pair pair) {
    constexpr int kBorders_px = 2 * kSsimBorder_px;
    const int end = area.top + area.height + kBorders_px;
    for (int y = area.top; y < area.top + kBorders_px; ++y) push(y);
    for (int y = area.top; y < area.top + area.height; y += 2) {
        push(y + kBorders_px);
        push(std::min(y + kBorders_px + 1, end - 1));
        pair(y);
    }
}

/// Reads the values of row `y` from `x` on, as many as there are weights; 0 where they do not count.
void read_counting(const ImageF& image, int x, int y, const std::vector<double>& weights,
                   std::vector<double>& values);

}  // namespace aoscore
