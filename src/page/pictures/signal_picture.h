#pragma once

#include "core/signal.h"
#include "image/image_file.h"
#include "page/pictures/pictures.h"

#include <filesystem>

namespace aoscore {

/// Makes a picture, at most `width_px` wide, of a signal's channels in an image file. A direction is in
/// colour, with its axes from -1 to 1 as red, green and blue, and black where there is none; a number is in
/// gray over its range. Throws file_error where a channel is missing; `path` is the file's.
Picture signal_picture(const Signal& signal, const ImageFile& file, const std::filesystem::path& path,
                       int width_px);

}  // namespace aoscore
