#include "reference/estimate/tile_law.h"

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// The usual law, V(N) = kUsualScale * visibility_shape() * N^log2(kUsualRatio), measured at 16, 64 and 256
/// rays on halls, a court, a staircase and scanned figures.
constexpr double kUsualRatio = 0.373;
constexpr double kUsualScale = 0.3;
/// Part of the usual scale that a tile has at least.
constexpr double kLeastScale = 0.7;
/// The usual scale counts like so many of a tile's pixels.
constexpr double kPriorPixels = 1;

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

double squared(double x) {
    return x * x;
}

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

}  // namespace

double visibility_shape(const PixelSpread& pixel) {
    const double v = pixel.visibility;
    return std::sqrt(v * (1 - v) + kShapeAtEnds / pixel.samples);
}

double size_shape(const PixelSpread& pixel) {
    return std::pow(block_size(pixel.samples), std::log2(kUsualRatio));
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

}  // namespace aoscore
