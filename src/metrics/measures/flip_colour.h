#pragma once

#include "metrics/measures/seen_image.h"

#include <span>

namespace aoscore {

/// Replaces luminances, clamped to [0,1], by CIELAB's L*, 0 to 100. A gray stays gray under the paper's
/// filters: both opponent channels are 0, and only luminance is left (its channel Yy is 116 Y - 16).
void to_lightness(std::span<double> luminances);

/// FLIP of each pixel of a row, in [0,1]: the perceived difference of two grays, of which small ones are
/// spread over most of the range and large ones compressed into the rest, raised to a power that comes nearer
/// to 0 as the features of the pixels differ more. Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller,
/// Magnus Oskarsson, Kalle Åström, Mark Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
/// 2020, sections 4.1.2, 4.1.3, 4.2.2 and 4.3.
void flip_differences(std::span<double> differences, const SeenRow& truth, const SeenRow& test);

}  // namespace aoscore
