#pragma once

namespace aoscore {

/// A rectangle of pixels: its left upper pixel, and how many there are each way.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;

    bool empty() const { return width < 1 || height < 1; }
    bool operator==(const PixelRect&) const = default;
};

}  // namespace aoscore
