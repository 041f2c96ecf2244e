#pragma once

#include "core/image.h"
#include "image/image_file.h"
#include "image/pixel_rect.h"

namespace aoscore {

/// The part of a rectangle of pixels that lies within a frame of this size.
PixelRect within_frame(const PixelRect& pixels, int frame_width, int frame_height);

/// Places a picture at `x`, `y` of a frame: pixels outside of the frame are dropped, and those of the frame
/// that the picture does not reach are NaN.
ImageF placed(const ImageF& picture, int x, int y, int frame_width, int frame_height);

/// Throws file_error where a channel has pixels for a part of its frame alone, as where an EXR's data window
/// is smaller than its display window. `where` names the file.
void require_whole_frame(const ImageFile& file, std::size_t channel, const std::string& where);

/// How a picture that is stored with an Orientation is to be shown: transposed first, then mirrored (left and
/// right change places), then turned over (top and bottom do).
struct Orientation {
    bool transposed = false, mirrored = false, turned_over = false;

    bool upright() const { return !transposed && !mirrored && !turned_over; }

    /// The meaning of the tag Orientation, 1 to 8 (Adobe, TIFF, revision 6.0, 1992; Exif has the same);
    /// upright for any other number.
    static Orientation of_tag(int tag);
};

template <class T>
Image<T> shown(const Image<T>& stored, const Orientation& orientation) {
    const int width = orientation.transposed ? stored.height : stored.width;
    const int height = orientation.transposed ? stored.width : stored.height;
    Image<T> result(width, height);
    if (stored.empty()) return result;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int column = orientation.mirrored ? width - 1 - x : x;
            const int row = orientation.turned_over ? height - 1 - y : y;
            result.at(x, y) = orientation.transposed ? stored.at(row, column) : stored.at(column, row);
        }
    }
    return result;
}
/// The place at which a rectangle of a stored picture of this size is shown.
PixelRect shown(PixelRect stored, int width, int height, const Orientation& orientation);

}  // namespace aoscore
