#pragma once

#include "core/image.h"

namespace aoscore {

/// FLIP's features of an image: the perceived lightness of each pixel (CIELAB's L*, 0 to 100), and the
/// strength of edge and point (lengths of the first and second derivative). Pontus Andersson, Jim Nilsson,
/// Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild, "FLIP: A Difference Evaluator for
/// Alternating Images", 2020, sections 4.1 and 4.2.1.
struct SeenImage {
    Image<double> lightness, edges, points;
};

/// A part of one row of it, from some pixel on.
struct SeenRow {
    const double *lightness, *edges, *points;
};

/// Computes the features of visibility in [0,1], which is shown as gray and taken as sRGB-coded. Invalid
/// pixels, which may be NaN, do not count, and their features mean nothing.
SeenImage seen_image(const ImageF& image, const Mask& valid);

}  // namespace aoscore
