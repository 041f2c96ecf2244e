#pragma once

#include "core/image.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/pixel_weights.h"
#include "metrics/measures/window_filter.h"

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
    /// The factors that make a mean of a weighted sum around the middle one of the last rows: 1 where all
    /// pixels count fully, and infinite where none counts.
    const double* scales();

  private:
    const PixelWeights& weights_;
    int left_;
    WindowFilter filter_;
    std::vector<double> row_, scales_;
};

/// A row of WindowMoments.
struct MomentRow {
    const double *mean, *variance;
};

/// The moments under the windows of an area, row by row.
class MovingMoments {
  public:
    /// Makes it for rows of `width` pixels that are read.
    explicit MovingMoments(std::size_t width);

    /// Pushes the next row: its values, 0 where they do not count, and their weights.
    void push(const std::vector<double>& values, const std::vector<double>& weights);
    /// The moments around the middle one of the last rows pushed, by MovingWeights' scales.
    MomentRow row(const double* scales);

  private:
    WindowFilter values_, squares_;
    std::vector<double> terms_, squared_terms_, mean_, variance_;
};

/// Reads the values of row `y` from `x` on, as many as there are weights; 0 where they do not count.
void read_counting(const ImageF& image, int x, int y, const std::vector<double>& weights,
                   std::vector<double>& values);

}  // namespace aoscore
