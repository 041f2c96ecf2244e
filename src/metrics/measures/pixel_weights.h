#pragma once

#include "core/image.h"

#include <span>

namespace aoscore {

/// How much each pixel of an image counts, from 0 to 1: as a mask says, or the mean of that over the pixels
/// that became one when the image was halved.
class PixelWeights {
  public:
    /// The mask must outlive it.
    explicit PixelWeights(const Mask& valid);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Whether all pixels count fully.
    bool all_one() const { return all_one_; }
    /// Those of row `y`; as many as the image is wide.
    void read_row(int y, std::span<double> weights) const;

    /// Of the image at half its size; an odd last row or column is dropped.
    PixelWeights halved() const;
    /// An image of this size at half of it: weighted means of 2x2 pixels, 0 where none counts. What does not
    /// count may be NaN.
    ImageF halved(const ImageF& image) const;

  private:
    explicit PixelWeights(ImageF halved);

    int width_, height_;
    const Mask* mask_ = nullptr;  ///< null where they are kept in `halved_`
    ImageF halved_;
    bool all_one_ = false;
};

}  // namespace aoscore
