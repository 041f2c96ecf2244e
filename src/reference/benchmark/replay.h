#pragma once

#include "reference/tracer/embree/embree_scene.h"
#include "reference/truth.h"

#include <cstdint>

namespace aoscore {

/// Million rays a second over the same random tiles of a picture, each the best of several runs: by processor
/// time of all threads, so that what else the machine does counts little.
struct ReplayRates {
    double traced = 0;   ///< as truths are made: directions, order, tracing, sums
    double single = 0;   ///< replay one by one
    double pixel = 0;    ///< replay in packets of sixteen rays of one pixel, sorted by direction
    double block = 0;    ///< replay in packets of 4x4 pixels at the same sample index
    double packets = 0;  ///< replay in the very packets in which truths are traced
    /// Of the orders that need no tile: one by one, by pixel, by block.
    double best_plain() const;
    std::uint64_t rays = 0;
};

/// The question that is asked of a ray.
enum class RayQuestion {
    occlusion,  ///< whether anything is hit: rtcOccluded1 and rtcOccluded16, one binary truth
    distance,   ///< of the first hit: rtcIntersect1 and rtcIntersect16, a truth of each falloff that has no
                ///< parameter
};

ReplayRates replay_rates(const EmbreeScene& scene, const CameraFrame& frame, double radius_m,
                         RayQuestion question, int samples, int tiles);

}  // namespace aoscore
