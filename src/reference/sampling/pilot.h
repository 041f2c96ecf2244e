#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace aoscore {

/// What the rays of one tile left to be wished for.
struct TileErrors {
    std::vector<double> error_sums;  ///< by query, of the standard errors of its pixels; empty: no surface
    std::size_t surfaces = 0;        ///< pixels that count for the mean
    std::size_t place = 0;           ///< along a curve on which neighbours are neighbours in the picture
};

/// Some tiles, traced with the same number of rays for every pixel.
struct PilotMeasure {
    std::vector<TileErrors> tiles;
    double seconds = 0;  ///< that tracing took what was not there before
};

/// The same number of rays for every pixel of a picture.
struct EvenRays {
    int samples = 0;
    double seconds = 0;  ///< that tracing the picture takes, as far as its pilot tells
};

/// Gives each pixel of the first `tiles` tiles so many rays; the first of any number are spread evenly over
/// the picture, see spread_tiles().
using TracePilot = std::function<PilotMeasure(std::size_t tiles, int samples)>;

/// Is told once, before much is traced, roughly how many rays it will be.
using TellRays = std::function<void(const EvenRays&)>;

/// Finds how many rays a pixel bring the mean standard error of a picture's surfaces, that of the query that
/// errs most, to within 4 % of `mean_error`: `first` where these are enough. Where proofs of open pixels,
/// which begin at 64 rays, make it leap, it ends below. Throws usage_error where that takes more rays than a
/// pixel can have, or more than a day, before it has traced them. `tell` may be empty.
///
/// A few tiles find roughly how many rays it will be. Then many get most of these, for the mean of a picture
/// that is told by few is as uncertain as its tiles differ. How the error falls from there on hardly differs
/// between tiles, so that the few tell it, and the many confirm it. So the many are visited twice, all others
/// once, by the picture, and no ray is traced in vain unless the few were far off.
///
/// All pixels get the same. To give each tile what it needs would spare 3 to 5 % of the rays on halls, courts
/// and railings and 1 % on hair, even if its error were known beforehand, since the errors of tiles differ
/// by half of their mean and a ray's gain falls as N^-1.7; but to find a tile's error its first rays must be
/// traced by themselves, and as rays are traced the faster the more there are of them at once, that takes 2
/// to 8 % more time (320x180, mean errors of 0.03 to 0.005). As one count for all, it is also the picture
/// that `--samples` gives.
EvenRays rays_for_mean_error(double mean_error, std::size_t tiles, int first, const TracePilot& trace,
                             const TellRays& tell = {});

}  // namespace aoscore
