#pragma once

#include "core/signal.h"
#include "image/image_file.h"
#include "metrics/signal_metric.h"
#include "page/pictures/pictures.h"

#include <filesystem>

namespace aoscore {

/// Makes a picture, at most `width_px` wide, of a signal's channels in an image file. A direction is in
/// colour, with its axes from -1 to 1 as red, green and blue, and black where there is none; a number is in
/// gray over its range. Throws file_error where a channel is missing; `path` is the file's.
Picture signal_picture(const Signal& signal, const ImageFile& file, const std::filesystem::path& path,
                       int width_px);

/// The planes of a signal's channels in an image file, whose path is `path`. Throws file_error where one is
/// missing.
SignalImage signal_planes(const Signal& signal, const ImageFile& file, const std::filesystem::path& path);

/// Degrees from the first colour of signal_error_picture() to the last: a direction's angle to the truth's
/// from 0 on, black to pale yellow; a number's difference from the truth, blue where it is too small, red
/// where it is too large.
struct SignalErrorRange {
    double low_deg = 0, high_deg = 0;
};
SignalErrorRange signal_error_range(const Signal& signal);

/// Makes a picture, at most `width_px` wide, of a signal's errors in degrees over that range, gray where the
/// pixels do not count.
Picture signal_error_picture(const Signal& signal, const SignalInput& input, int width_px);

}  // namespace aoscore
