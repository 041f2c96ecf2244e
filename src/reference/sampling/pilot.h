#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace aoscore {

/// What the rays of one tile left to be wished for.
struct TileErrors {
    std::vector<double> error_sums;  ///< by query, of the standard errors of its pixels; empty: no surface
    std::size_t surfaces = 0;        ///< pixels that count for the mean
};

/// The same number of rays for every pixel of a picture.
struct EvenRays {
    int samples = 0;
    double seconds = 0;  ///< that tracing the picture takes, as far as its pilot tells
};

/// Gives each pixel of the first `tiles` tiles so many rays; tiles come in random order.
using TracePilot = std::function<std::vector<TileErrors>(std::size_t tiles, int samples)>;

/// Is told once, before much is traced, roughly how many rays it will be.
using TellRays = std::function<void(const EvenRays&)>;

/// Finds how many rays a pixel bring the mean standard error of a picture's surfaces, that of the query that
/// errs most, to within 4 % of `mean_error`: `first` where these are enough. Where proofs of open pixels,
/// which begin at 64 rays, make it leap, it ends below. Throws usage_error where that takes more rays than a
/// pixel can have, or more than a day, before it has traced them. `tell` may be empty.
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
