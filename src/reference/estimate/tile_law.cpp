#include "reference/estimate/tile_law.h"

#include "reference/estimate/squared.h"
#include "reference/estimate/variance_fall.h"
#include "reference/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace aoscore {
namespace {

/// The usual law, V(N) = kUsualScale * visibility_shape() * variance_after_falls(kUsualRatio, N), measured at
/// 16, 64 and 256 rays on halls, a court, a staircase and scanned figures.
constexpr double kUsualRatio = 0.373;
constexpr double kUsualScale = 0.33;
/// Part of the usual scale that a tile has at least.
constexpr double kLeastScale = 0.7;
/// The usual scale counts like so many of a tile's pixels.
constexpr double kPriorPixels = 1;

/// Neighbours speak for a pixel by a Gaussian of this standard deviation, in pixels; against all of them, the
/// tile's scale counts like so many.
constexpr double kNearby = 1.6;
constexpr double kTilePixels = 8;
/// Part of the usual scale that a pixel has at least.
constexpr double kLeastNearby = 0.6;

/// The part of a variance that doubling leaves among hairs: the slowest fall seen. Both laws state the same
/// at so many rays, from where on the scale of hairs grows against the usual one.
constexpr double kSlowRatio = 0.477;
constexpr double kMeetingSamples = 3.2;
/// Below so many rays the laws cannot be told apart.
constexpr int kLeastSamplesToTell = 8;
/// A tile begins to count as thin at this part of the way, in logarithms, from the usual scale to that of
/// hairs.
constexpr double kThinFrom = 0.15;
/// Thin occluders leave no two neighbours alike: standard deviations of true visibility over the tile at
/// which it may begin to count as thin, and may fully.
constexpr double kSmoothSpread = 0.03, kRoughSpread = 0.1;

/// Keeps the shape above 0 where all rays agree, in units of one ray.
constexpr double kShapeAtEnds = 0.8;

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// The scale that the pixels' own differences have, moderated by the usual one.
double fitted_scale(std::span<const PixelSpread> pixels, double ratio) {
    double variances = 0, shapes = 0, count = 0;
    for (const PixelSpread& pixel : pixels) {
        if (pixel.freedom() == 0) continue;
        variances += block_variance(pixel, ratio);
        shapes += visibility_shape(pixel) * size_shape(pixel);
        ++count;
    }
    if (count == 0) return kUsualScale;
    const double prior = kPriorPixels * shapes / count;
    return (variances + kUsualScale * prior) / (shapes + prior);
}

/// Standard deviation over the tile of the visibility itself, without that of its estimates.
double spread_of_visibility(std::span<const PixelSpread> pixels) {
    double sum = 0, squares = 0, noise = 0;
    for (const PixelSpread& pixel : pixels) {
        sum += pixel.visibility;
        squares += squared(pixel.visibility);
        noise += block_variance(pixel, kUsualRatio) * pooled_variance(pixel.samples, kUsualRatio);
    }
    const auto count = static_cast<double>(pixels.size());
    return std::sqrt(std::max(0.0, (squares - noise) / count - squared(sum / count)));
}

double thinness_of(std::span<const PixelSpread> pixels, double scale) {
    double octaves = 0;
    for (const PixelSpread& pixel : pixels) octaves += std::log2(pixel.samples);
    octaves /= static_cast<double>(pixels.size());
    if (octaves < std::log2(kLeastSamplesToTell)) return 0;
    const double whole_way = std::log2(kSlowRatio / kUsualRatio) * (octaves - std::log2(kMeetingSamples));
    const double by_scale = smooth_step(kThinFrom, 1, std::log2(scale / kUsualScale) / whole_way);
    if (by_scale == 0) return 0;
    const double rough = (spread_of_visibility(pixels) - kSmoothSpread) / (kRoughSpread - kSmoothSpread);
    return by_scale * std::clamp(rough, 0.0, 1.0);
}

/// Values over a tile, which may hold 0 or several pixels at a place.
using Grid = std::array<std::array<double, kLargestTile>, kLargestTile>;

double weight_at(int distance) {
    static const auto weights = [] {
        std::array<double, kLargestTile> table{};
        for (std::size_t d = 0; d < table.size(); ++d)
            table[d] = std::exp(-squared(static_cast<double>(d) / kNearby) / 2);
        return table;
    }();
    return weights[static_cast<std::size_t>(std::abs(distance))];
}

/// Sums over each place's neighbours and itself, along the columns and turned by a quarter: twice done, it
/// stands as before.
Grid summed_along(const Grid& values) {
    Grid sums{};
    for (int i = 0; i < kLargestTile; ++i) {
        for (int j = 0; j < kLargestTile; ++j) {
            const double weight = weight_at(i - j);
            for (int k = 0; k < kLargestTile; ++k) sums[k][i] += weight * values[j][k];
        }
    }
    return sums;
}

double& at(Grid& grid, const PlaceInTile& place) {
    return grid[static_cast<std::size_t>(place.row)][static_cast<std::size_t>(place.column)];
}

}  // namespace

double visibility_shape(const PixelSpread& pixel) {
    const double v = pixel.visibility;
    return std::sqrt(v * (1 - v) + kShapeAtEnds / pixel.samples);
}

double size_shape(const PixelSpread& pixel) {
    return variance_after_falls(kUsualRatio, block_size(pixel.samples));
}

TileLaw law_of_tile(std::span<const PixelSpread> pixels, const TileLawRules& rules) {
    TileLaw law;
    law.scale = fitted_scale(pixels, kUsualRatio);
    law.thinness = thinness_of(pixels, law.scale);
    law.ratio = kUsualRatio + (rules.chosen ? 1 : law.thinness) * (kSlowRatio - kUsualRatio);
    law.scale = fitted_scale(pixels, law.ratio);
    if (rules.binary) law.scale = std::max(law.scale, kLeastScale * kUsualScale);
    double shapes = 0, count = 0;
    for (const PixelSpread& pixel : pixels) {
        if (pixel.agrees()) continue;
        shapes += visibility_shape(pixel);
        ++count;
    }
    if (count > 0) law.mean_shape = shapes / count;
    return law;
}

std::vector<double> scales_about(std::span<const PixelSpread> pixels, const TileLaw& law,
                                 const TileLawRules& rules) {
    Grid variances{}, shapes{};
    double sum = 0;
    for (const PixelSpread& pixel : pixels) {
        const double shape = visibility_shape(pixel) * size_shape(pixel);
        sum += shape;
        if (pixel.freedom() == 0) continue;
        at(variances, pixel.place) += block_variance(pixel, law.ratio);
        at(shapes, pixel.place) += shape;
    }
    variances = summed_along(summed_along(variances));
    shapes = summed_along(summed_along(shapes));
    const double of_tile = kTilePixels * sum / static_cast<double>(pixels.size());
    const double least = rules.binary ? kLeastNearby * kUsualScale : 0;
    std::vector<double> scales;
    scales.reserve(pixels.size());
    for (const PixelSpread& pixel : pixels) {
        const double about =
            (at(variances, pixel.place) + law.scale * of_tile) / (at(shapes, pixel.place) + of_tile);
        scales.push_back(std::max(about, least));
    }
    return scales;
}

}  // namespace aoscore
