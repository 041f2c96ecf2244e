#pragma once

#include <vector>

namespace aoscore {

/// A part of an image, in pixels.
struct ImageArea {
    int left, top, width, height;
};

/// Cuts an image into areas for filters: narrow enough for the rows that a filter keeps to stay in cache,
/// large enough for margins to cost little.
std::vector<ImageArea> image_areas(int width, int height);

}  // namespace aoscore
