#pragma once

#include "core/image.h"

namespace aoscore {

/// What FLIP finds in an image before it compares: how light each pixel is seen (CIELAB's L*, 0 to 100), and
/// how strong edge and point are there (lengths of the first and second derivative). Pontus Andersson, Jim
/// Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", 2020, sections 4.1 and 4.2.1.
struct SeenImage {
    Image<double> lightness, edges, points;
};

/// Of visibility in [0,1], which is shown as gray and taken as sRGB-coded. Invalid pixels, which may be NaN,
/// have no part in it; what stands there means nothing.
SeenImage seen_image(const ImageF& image, const Mask& valid);

}  // namespace aoscore
