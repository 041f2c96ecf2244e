#pragma once

#include <vector>

namespace aoscore {

/// A part of an image, in pixels.
struct FlipArea {
    int left, top, width, height;
};

/// Cuts an image into areas for FLIP: low enough for an area's rows to stay in cache, large enough for
/// margins to cost little.
std::vector<FlipArea> flip_areas(int width, int height);

}  // namespace aoscore
