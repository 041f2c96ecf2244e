#pragma once

#include "screen/method/depth_layers.h"

#include <cstdint>
#include <vector>

namespace aoscore {

/// Depth layers of further cameras beside the view's own, for a method. Each camera has the projection, the
/// size and the near and far plane of the view's. The first stands to the right and in front of it and looks
/// at a point ahead of it (Vermeer, Stochastic-Depth Ambient Occlusion, 2020, sections 7.2 and 8.2, which
/// prints no numbers); further ones are turned about its line of sight by equal angles.
struct SideLayers {
    static constexpr int kMostCameras = 4;
    static constexpr int kMostScale = 8;
    int cameras = 0;  ///< 0 to kMostCameras
    int scale = 1;    ///< their pictures are drawn at 1/scale of the width and height, 1 to kMostScale
    double right_m = 0, ahead_m = 0;  ///< the first camera's place in the view's camera space, metres
    double aim_m = 0;  ///< depth of the point that they look at, metres; 0: midway from near to far plane
    DepthLayers layers;
};

/// The members of a descriptor's "side_layers": those of "depth_layers", and the cameras'.
const std::vector<Parameter>& side_layers_members();

/// The side layers for these parameters, in a run of this seed.
SideLayers asked_side_layers(const InputMembers& input, const ParameterValues& parameters,
                             std::uint64_t run_seed);

}  // namespace aoscore
