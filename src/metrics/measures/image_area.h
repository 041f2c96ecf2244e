#pragma once

#include "core/image.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace aoscore {

/// A part of an image, in pixels.
struct ImageArea {
    int left, top, width, height;
};

/// Cuts an image into areas for filters: narrow enough for the rows that a filter keeps to stay in cache,
/// large enough for margins to cost little.
std::vector<ImageArea> image_areas(int width, int height);

/// Whether all of these pixels count.
inline bool all_count(const std::uint8_t* valid, std::size_t count) {
    return count == 0 || std::memchr(valid, 0, count) == nullptr;
}

/// How many rows before it is read a row is fetched.
inline constexpr int kRowsAhead = 2;

/// Has the processor fetch the pixels from `left` to `right` of row `y`, where it lies within the image. It
/// does not foresee by itself that an area's next row lies a whole row of the image further on, and would
/// wait for it. Always inlined, since GCC 12 takes a function that only fetches ahead for one without any
/// effect.
template <class T>
[[gnu::always_inline]] inline void fetch_ahead(const Image<T>& image, int left, int right, int y) {
    constexpr int kLine_px = 64 / sizeof(T);
    if (y >= image.height) return;
    const T* row = &image.at(0, y);
    for (int x = std::max(left, 0); x < std::min(right + kLine_px, image.width); x += kLine_px)
        __builtin_prefetch(row + x);
}

}  // namespace aoscore
