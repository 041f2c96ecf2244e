#pragma once

#include <vector>

namespace aoscore {

/// A part of an image, pixels.
struct FlipArea {
    int left, top, width, height;
};

/// An image cut into parts that FLIP looks at one by one: low enough for what is kept of a part's rows to
/// stay in cache, large enough for margins to cost little.
std::vector<FlipArea> flip_areas(int width, int height);

}  // namespace aoscore
