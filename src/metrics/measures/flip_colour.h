#pragma once

#include "metrics/measures/seen_image.h"

#include <cstddef>
#include <span>

namespace aoscore {

/// A row of responses to FLIP's filters: the luminances that the eye sees, and the derivatives in x and y.
struct ResponseRow {
    const double *seen, *edge_x, *edge_y, *point_x, *point_y;
};

/// A row of features to be filled.
struct FeatureRow {
    double *lightness, *edges, *points;
};

/// Finds the features of `count` pixels: CIELAB's L*, 0 to 100, of luminances, which are clamped to [0,1],
/// and the lengths of the derivatives. A gray stays gray under the paper's filters: both opponent channels
/// are 0, and only luminance is left (its channel Yy is 116 Y - 16).
void find_features(const ResponseRow& responses, const FeatureRow& features, std::size_t count);

/// FLIP of each pixel of a row, in [0,1]: the perceived difference of two grays, of which small ones are
/// spread over most of the range and large ones compressed into the rest, raised to a power that comes nearer
/// to 0 as the features of the pixels differ more. Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller,
/// Magnus Oskarsson, Kalle Åström, Mark Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
/// 2020, sections 4.1.2, 4.1.3, 4.2.2 and 4.3.
void flip_differences(std::span<double> differences, const SeenRow& truth, const SeenRow& test);

}  // namespace aoscore
