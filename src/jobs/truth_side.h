#pragma once

#include "jobs/ground.h"
#include "metrics/analysis/pixel_divisions.h"
#include "metrics/prepared_image.h"
#include "reference/truth.h"

#include <span>
#include <vector>

namespace aoscore {

/// The common part of the scores of all images of a view, which is made once: the metrics' preparation of the
/// ranking's truth, and the division of pixels. Only one thread may use it.
class TruthSide {
  public:
    /// Both arguments must outlive this object.
    TruthSide(const Truth& truth, const Ground& ground);

    /// The truth of the first query and then its halves, where it has them, on the ground's valid pixels;
    /// empty where the picture is so large that keeping it would take too much memory.
    std::span<const PreparedImage> images() const { return images_; }
    const std::vector<PixelDivision>& divisions() const { return divisions_; }

  private:
    std::vector<PreparedImage> images_;
    std::vector<PixelDivision> divisions_;
};

}  // namespace aoscore
