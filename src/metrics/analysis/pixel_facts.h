#pragma once

#include "core/image.h"

#include <string>
#include <vector>

namespace aoscore {

/// Facts about pixels besides truth and test, by which errors are split and explained. Where an image or list
/// is empty, its splits are left out; the others have the size of the truth.
struct PixelFacts {
    ImageF depth_m;           ///< view depth -z
    ImageF tilt;              ///< |n v|, cosine between normal and line of sight, in [0,1]
    ImageF edge_distance_px;  ///< distance to the nearest pixel beside a depth edge
    ImageF behind_edge_px;    ///< distance to the nearest pixel on the far side of one
    /// Occlusion of the truth by one cause, in [0,1]; all causes add up to 1 - visibility.
    struct Cause {
        std::string name;
        const ImageF* occlusion = nullptr;
    };
    std::vector<Cause> causes;
    /// The occlusion of the truth that one depth layer shows at most; null where it is not known.
    const ImageF* one_layer = nullptr;
};

}  // namespace aoscore
