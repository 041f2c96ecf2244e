#pragma once

#include <string>

namespace aoscore {

class StrictObject;

/// Width and height of a picture in pixels, each from 1 to kLargestImageSide_px.
struct ImageSize {
    int width = 1920, height = 1080;
    bool operator==(const ImageSize&) const = default;
};

/// Reads "1920x1080". Throws usage_error, which names `where`, for another form and for sides out of range.
ImageSize parse_image_size(const std::string& text, const std::string& where);

/// Takes the member "size": [1920, 1080]. Throws file_error for another form and for sides out of range.
ImageSize read_image_size(StrictObject& object);

}  // namespace aoscore
