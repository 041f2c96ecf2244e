#include "image/image_frame.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace aoscore {

PixelRect within_frame(const PixelRect& pixels, int frame_width, int frame_height) {
    const int left = std::max(pixels.x, 0), top = std::max(pixels.y, 0);
    const int right = std::min(pixels.x + pixels.width, frame_width);
    const int bottom = std::min(pixels.y + pixels.height, frame_height);
    return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

ImageF placed(const ImageF& picture, int x, int y, int frame_width, int frame_height) {
    ImageF frame(frame_width, frame_height, std::numeric_limits<float>::quiet_NaN());
    const PixelRect part = within_frame({x, y, picture.width, picture.height}, frame_width, frame_height);
    for (int row = part.y; row < part.y + part.height; ++row) {
        const float* from = &picture.at(part.x - x, row - y);
        std::copy(from, from + part.width, &frame.at(part.x, row));
    }
    return frame;
}

void require_whole_frame(const ImageFile& file, std::size_t channel, const std::string& where) {
    const PixelRect& covered = file.covered[channel];
    if (covered == PixelRect{0, 0, file.width, file.height}) return;
    throw file_error(
        fmt::format("holds {}x{} pixels at {}, {} of its {}x{}: its data window is only a part of its "
                    "display window",
                    covered.width, covered.height, covered.x, covered.y, file.width, file.height),
        where, "a file with a pixel everywhere");
}

Orientation Orientation::of_tag(int tag) {
    static constexpr std::array<Orientation, 9> kByTag{{{},
                                                        {false, false, false},
                                                        {false, true, false},
                                                        {false, true, true},
                                                        {false, false, true},
                                                        {true, false, false},
                                                        {true, true, false},
                                                        {true, true, true},
                                                        {true, false, true}}};
    return tag < 1 || tag > 8 ? Orientation{} : kByTag[static_cast<std::size_t>(tag)];
}

PixelRect shown(PixelRect stored, int width, int height, const Orientation& orientation) {
    if (orientation.transposed) {
        std::swap(stored.x, stored.y);
        std::swap(stored.width, stored.height);
        std::swap(width, height);
    }
    if (orientation.mirrored) stored.x = width - stored.x - stored.width;
    if (orientation.turned_over) stored.y = height - stored.y - stored.height;
    return stored;
}

}  // namespace aoscore
