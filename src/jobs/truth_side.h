#pragma once

#include "jobs/ground.h"
#include "metrics/analysis/pixel_divisions.h"
#include "metrics/prepared_halves.h"
#include "metrics/prepared_image.h"
#include "reference/truth.h"

#include <optional>
#include <vector>

namespace aoscore {

/// The common part of the scores of all images of a view, which is made once: the metrics' preparation of the
/// ranking's truth, and the division of pixels. Only one thread may use it.
class TruthSide {
  public:
    /// Both arguments must outlive this object.
    TruthSide(const Truth& truth, const Ground& ground);

    /// The truth of the first query on the ground's valid pixels: undivided, or with its halves. Both are
    /// null where the picture is so large that keeping it would take too much memory.
    const PreparedImage* undivided() const { return undivided_ ? &*undivided_ : nullptr; }
    const PreparedHalves* halves() const { return halves_ ? &*halves_ : nullptr; }
    const std::vector<PixelDivision>& divisions() const { return divisions_; }

  private:
    std::optional<PreparedImage> undivided_;
    std::optional<PreparedHalves> halves_;
    std::vector<PixelDivision> divisions_;
};

}  // namespace aoscore
