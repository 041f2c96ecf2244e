#pragma once

#include "core/image.h"
#include "screen/gbuffer/capture.h"

#include <string>
#include <string_view>

namespace aoscore {

/// A band around the picture that is drawn and shaded with it, and then cut off: taps beyond the picture's
/// edge find what lies there (Gravås, Image-space Ambient Obscurance in WebGL, 2013, section 2.3.3.1).
struct GuardBand {
    double width = 0;         ///< on every side, >= 0; 0: none
    bool is_percent = false;  ///< of the picture's width and height, not pixels

    bool operator==(const GuardBand&) const = default;

    /// Pixels on the left and on the right (x), above and below (y), rounded up.
    glm::ivec2 pixels(int picture_width, int picture_height) const;
};

/// The band of "64" (pixels) or "10%". Throws usage_error for other text, and for more than 4096 or 100 %.
GuardBand parse_guard_band(std::string_view text);
/// The text that parse_guard_band() reads.
std::string text_of(const GuardBand& band);

/// The capture with a band around each of its pictures: the centres of the inner pixels see what they saw.
Capture widened(const Capture& capture, const glm::ivec2& band_px);

/// The picture of this size inside of a band.
template <class Pixel>
Image<Pixel> without_band(const Image<Pixel>& wide, const glm::ivec2& band_px) {
    if (band_px == glm::ivec2(0)) return wide;
    Image<Pixel> inner(wide.width - 2 * band_px.x, wide.height - 2 * band_px.y);
    for (int y = 0; y < inner.height; ++y) {
        for (int x = 0; x < inner.width; ++x) inner.at(x, y) = wide.at(x + band_px.x, y + band_px.y);
    }
    return inner;
}

}  // namespace aoscore
