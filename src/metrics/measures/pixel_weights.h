#pragma once

#include "core/image.h"

#include <span>

namespace aoscore {

/// The weight of each pixel of an image, from 0 to 1: its value in a mask, or the mean of the weights of the
/// pixels that halving the image merged.
class PixelWeights {
  public:
    /// The mask must outlive it.
    explicit PixelWeights(const Mask& valid);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Whether all pixels count fully.
    bool all_one() const { return all_one_; }
    /// Reads the weights of row `y` from `x` on, as many as the span holds.
    void read_row(int x, int y, std::span<double> weights) const;

    /// The weights of the image at half its size; an odd last row or column is dropped.
    PixelWeights halved() const;
    /// Halves an image of this size by weighted means of 2x2 pixels, 0 where none counts. Pixels of weight 0
    /// may be NaN.
    ImageF halved(const ImageF& image) const;

  private:
    explicit PixelWeights(ImageF halved);
    /// Makes those of an image whose pixels all count fully.
    PixelWeights(int width, int height) : width_(width), height_(height), all_one_(true) {}

    int width_, height_;
    const Mask* mask_ = nullptr;  ///< null where `halved_` has the weights
    ImageF halved_;               ///< empty where all are 1
    bool all_one_ = false;
};

}  // namespace aoscore
