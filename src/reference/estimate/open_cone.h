#pragma once

#include "reference/estimate/tile_law.h"
#include "reference/truth.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace aoscore {

/// Sums over the rays of one pixel, uniform over its hemisphere, by blocks of block_size() of them. All are
/// exact, whatever their order.
struct OpenSums {
    static constexpr double kDirectionStep = 0x1p-20;
    std::array<double, kBlocks> open{};           ///< 1 - g; multiples of kOcclusionStep
    std::array<glm::dvec3, kBlocks> direction{};  ///< of (1 - g) times the direction; of kDirectionStep
    bool operator==(const OpenSums&) const = default;
};

/// The mean open direction of a pixel, the cone about it, and their standard errors.
struct OpenCone {
    glm::dvec3 bent_normal{0};  ///< no longer than 1; 0 where no ray is open
    double bent_error_rad = 0;  ///< root of the mean squared angle to the true direction; at most pi/2
    double cone_rad = 0;        ///< see cone_angle_rad()
    double cone_error_rad = 0;  ///< at most pi/2
};

/// Those of the pixels of one tile, whose `samples` count rays in their sums.
///
/// The bent normal is the ratio of two means, so that its error is, to first order, that of the mean of
/// residuals (1 - g) (w - n'). Their blocks are compared as those of visibility are (see PixelSpread), by
/// component across and along n', drawn towards what the tile's pixels have, and shrink with more rays by the
/// law of the tile (see TileLaw). Where no ray is open
/// nothing is known of the direction, and both errors are pi/2.
std::vector<OpenCone> open_cones(std::span<const OpenSums> sums, std::span<const int> samples,
                                 const TileLawRules& rules);

/// Half angle of the cone that is as open as a bent normal is long, pi/2 (1 - max(2 |n'| - 1, 0)): pi/2 for
/// the open hemisphere, where |n'| = 1/2 (Vermeer, Stochastic-Depth Ambient Occlusion, 2020, section 7.1).
double cone_angle_rad(const glm::dvec3& bent_normal);

}  // namespace aoscore
