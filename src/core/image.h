#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aoscore {

/// The longest side of any picture that is read, drawn or traced.
inline constexpr int kLargestImageSide_px = 16384;

/// A picture in memory: `width` x `height` pixels, row by row, row 0 at the top, x to the right.
template <class T>
struct Image {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;

    Image() = default;
    Image(int w, int h, T fill = T{})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    bool empty() const { return pixels.empty(); }
    std::size_t size() const { return pixels.size(); }

    std::size_t index(int x, int y) const {
        assert(x >= 0 && x < width && y >= 0 && y < height);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    T& at(int x, int y) { return pixels[index(x, y)]; }
    const T& at(int x, int y) const { return pixels[index(x, y)]; }

    template <class U>
    bool same_size(const Image<U>& other) const {
        return width == other.width && height == other.height;
    }
};

/// 1 where a pixel counts, 0 where it does not.
using Mask = Image<std::uint8_t>;
using ImageF = Image<float>;

}  // namespace aoscore
