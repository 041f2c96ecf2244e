#pragma once

#include "reference/truth.h"

#include <cstddef>
#include <vector>

namespace aoscore {

/// Random groups of neighbouring tiles of a picture, always the same ones: a picture in small that has the
/// large one's tiles.
class RandomTiles {
  public:
    RandomTiles(const ReferenceScene& scene, const CameraFrame& frame, std::size_t groups);

    /// The truth of these tiles; everything else is without surface.
    Truth trace(const std::vector<TruthQuery>& queries, const TruthSettings& settings) const;
    /// Their part of the picture.
    double part() const { return part_; }

  private:
    const ReferenceScene& scene_;
    const CameraFrame& frame_;
    std::vector<std::size_t> groups_;
    double part_;
};

/// Mean standard error of the first query over the pixels with a surface; 0 without any.
double mean_standard_error(const Truth& truth);

}  // namespace aoscore
