#pragma once

#include "reference/embree_scene.h"
#include "reference/truth.h"

#include <vector>

namespace aoscore {

/// Million rays a second over the same random tiles of a picture, each the best of several runs: by processor
/// time of all threads, so that what else the machine does counts little.
struct ReplayRates {
    double traced = 0;    ///< as truths are made: directions, order, tracing, sums
    double single = 0;    ///< replay by rtcOccluded1
    double pixel = 0;     ///< replay by rtcOccluded16 over sixteen rays of one pixel, sorted by direction
    double block = 0;     ///< replay by rtcOccluded16 over 4x4 pixels at the same sample index
    double sorted = 0;    ///< replay by rtcOccluded16 in the order in which truths are traced
    double best() const;  ///< of the replays
    std::uint64_t rays = 0;
};

ReplayRates replay_rates(const EmbreeScene& scene, const CameraFrame& frame, double radius_m, int samples,
                         int tiles);

}  // namespace aoscore
