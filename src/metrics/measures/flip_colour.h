#pragma once

#include <span>

namespace aoscore {

/// Replaces luminances, clamped to [0,1], by CIELAB's L*, 0 to 100. A gray stays gray under the paper's
/// filters: both opponent channels are 0, and only luminance is left (its channel Yy is 116 Y - 16).
void to_lightness(std::span<double> luminances);

/// FLIP's perceived difference between two grays, in [0,1], for each pixel of a row: small differences are
/// spread over most of it, large ones compressed into the rest. `truth` and `test` hold as many lightnesses
/// as `differences` receives. Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle
/// Åström, Mark Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020, sections 4.1.2 and
/// 4.1.3.
void flip_color_differences(std::span<double> differences, const double* truth, const double* test);

}  // namespace aoscore
