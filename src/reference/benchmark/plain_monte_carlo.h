#pragma once

#include "reference/integrator/tile.h"
#include "reference/tracer/embree/embree_scene.h"
#include "reference/truth.h"

#include <span>
#include <vector>

namespace aoscore {

/// Plain Monte Carlo over the pixels of a picture whose visibility is known: what independent rays would err,
/// by sqrt(V (1 - V) / N). It is asked for no floor, so that its error is the least it could state.
class PlainMonteCarlo {
  public:
    /// Over the pixels with a surface.
    explicit PlainMonteCarlo(const Truth& truth);

    /// Rays a pixel, the same for all, until the mean standard error is `error`.
    double samples_for(double error) const;
    /// Rays a pixel in the mean, if each pixel got as many as are best for the mean standard error, which
    /// nobody knows beforehand: n ~ deviation^(2/3).
    double best_samples_for(double error) const;

  private:
    std::vector<double> deviations_;
};

/// Million rays a second, by processor time of all threads, of plain Monte Carlo as one would write it down:
/// pixel by pixel and ray by ray, random numbers, a direction, rtcOccluded1, a sum. The best of several runs
/// over these tiles.
double plain_rate(const EmbreeScene& scene, const CameraFrame& frame, double radius_m, int samples,
                  std::span<const Tile> tiles);

}  // namespace aoscore
