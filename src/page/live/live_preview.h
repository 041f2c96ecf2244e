#pragma once

#include "core/image.h"

#include <algorithm>

namespace aoscore {

/// A preview of a view has every so many pixels of its G-buffer, which a camera of fewer and larger pixels
/// would see too: about 320 in a row, and at most a ninth of all, so that it is unpacked and drawn long
/// before the rest.
int preview_factor(int width);

/// The middle pixel of each square of `factor` pixels; what the picture cuts off of the last squares counts
/// as its edge.
template <class T>
Image<T> preview_of(const Image<T>& image, int factor) {
    const auto middle = [&](int i, int size) { return std::min(i * factor + factor / 2, size - 1); };
    Image<T> preview((image.width + factor - 1) / factor, (image.height + factor - 1) / factor);
    for (int y = 0; y < preview.height; ++y) {
        for (int x = 0; x < preview.width; ++x)
            preview.at(x, y) = image.at(middle(x, image.width), middle(y, image.height));
    }
    return preview;
}

}  // namespace aoscore
