#include "reference/estimate/open_cone.h"

#include "core/sampling.h"
#include "reference/estimate/pixel_spread.h"
#include "reference/estimate/squared.h"
#include "reference/estimate/tile_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

/// The weight of the tile's scale against a pixel's own spread, in degrees of freedom.
constexpr double kConePriorFreedom = 16;
/// One ray may always lie on the wrong side of an edge: no component errs less than this over the open rays.
constexpr double kLeastError = 0.3;

constexpr double kUnknown_rad = std::numbers::pi / 2;

/// The means of one pixel's residuals, the third along its bent normal.
struct Residuals {
    double open = 0;  ///< rays
    glm::dvec3 bent_normal{0};
    std::array<PixelSpread, 3> spreads;
    PixelSpread occlusion;  ///< of uniform directions

    Residuals(const OpenSums& sums, int samples) {
        std::array<double, kBlocks> parts{};
        glm::dvec3 direction(0);
        for (std::size_t b = 0; b < kBlocks; ++b) {
            open += sums.open[b];
            direction += sums.direction[b];
        }
        std::ranges::copy(sums.open, parts.begin());
        occlusion = pixel_spread(parts, samples);  // whose law is that of visibility
        if (open == 0) return;
        bent_normal = direction / open;
        const double length = glm::length(bent_normal);
        const glm::dmat3 axes = frame_about(length > 0 ? bent_normal / length : glm::dvec3(0, 0, 1));
        for (int axis = 0; axis < 3; ++axis) {
            for (std::size_t b = 0; b < kBlocks; ++b)
                parts[b] = glm::dot(sums.direction[b] - sums.open[b] * bent_normal, axes[axis]);
            spreads[static_cast<std::size_t>(axis)] = pixel_spread(parts, samples);
        }
    }

    /// How the variance of a block is taken to depend on what is open, and on its rays.
    double shape() const { return visibility_shape(occlusion) * size_shape(occlusion); }
};

/// How residuals vary over a tile.
struct TileScale {
    double ratio = 0;  ///< by which doubling the rays lowers a variance: as of the openness
    double scale = 0;  ///< variance of a block over its shape, in the mean
};

TileScale tile_scale(std::span<const Residuals> pixels, const TileLawRules& rules) {
    std::vector<PixelSpread> occlusions;
    for (const Residuals& pixel : pixels) occlusions.push_back(pixel.occlusion);
    const double ratio = law_of_tile(occlusions, rules).ratio;
    double variances = 0, shapes = 0;
    for (const Residuals& pixel : pixels) {
        if (pixel.open == 0) continue;
        for (const PixelSpread& spread : pixel.spreads) {
            if (spread.freedom() == 0) continue;
            variances += block_variance(spread, ratio);
            shapes += pixel.shape();
        }
    }
    return {ratio, shapes > 0 ? variances / shapes : 0};
}

/// Of one component of the bent normal.
double variance(const Residuals& pixel, std::size_t axis, const TileScale& tile) {
    const PixelSpread& spread = pixel.spreads[axis];
    const int samples = pixel.occlusion.samples, freedom = spread.freedom();
    const double block =
        (kConePriorFreedom * tile.scale * pixel.shape() + freedom * block_variance(spread, tile.ratio)) /
        (kConePriorFreedom + freedom);
    const double of_mean = block * pooled_variance(samples, tile.ratio);
    return std::max(of_mean * squared(samples / pixel.open), squared(kLeastError / pixel.open));
}

OpenCone cone_of(const Residuals& pixel, const TileScale& tile) {
    if (pixel.open == 0) return {glm::dvec3(0), kUnknown_rad, 0, kUnknown_rad};
    const double across = variance(pixel, 0, tile) + variance(pixel, 1, tile);
    const double along = variance(pixel, 2, tile), length = glm::length(pixel.bent_normal);
    OpenCone cone{pixel.bent_normal, kUnknown_rad, cone_angle_rad(pixel.bent_normal), kUnknown_rad};
    if (length == 0) return cone;
    cone.bent_error_rad = std::min(std::sqrt(across) / length, kUnknown_rad);
    // The error across lengthens a mean direction, in the second order.
    const double length_error = std::sqrt(along + squared(across / (2 * length)));
    cone.cone_error_rad = std::min(std::numbers::pi * length_error, kUnknown_rad);
    return cone;
}

}  // namespace

std::vector<OpenCone> open_cones(std::span<const OpenSums> sums, std::span<const int> samples,
                                 const TileLawRules& rules) {
    std::vector<Residuals> pixels;
    pixels.reserve(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) pixels.emplace_back(sums[i], samples[i]);
    if (pixels.empty()) return {};
    const TileScale tile = tile_scale(pixels, rules);
    std::vector<OpenCone> cones;
    cones.reserve(pixels.size());
    for (const Residuals& pixel : pixels) cones.push_back(cone_of(pixel, tile));
    return cones;
}

double cone_angle_rad(const glm::dvec3& bent_normal) {
    return std::numbers::pi / 2 * (1 - std::clamp(2 * glm::length(bent_normal) - 1, 0.0, 1.0));
}

}  // namespace aoscore
