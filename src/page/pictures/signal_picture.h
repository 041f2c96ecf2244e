#pragma once

#include "core/signal.h"
#include "image/image_file.h"
#include "page/pictures/pictures.h"

#include <filesystem>

namespace aoscore {

/// A signal's channels of an image file as a picture, at most `width_px` wide: a direction in colour, each
/// axis from -1 to 1 one of red, green and blue, and black where there is none; a number in gray, from the
/// low to the high end of its range. Throws file_error where a channel is missing; `path` is the file's.
Picture signal_picture(const Signal& signal, const ImageFile& file, const std::filesystem::path& path,
                       int width_px);

}  // namespace aoscore
