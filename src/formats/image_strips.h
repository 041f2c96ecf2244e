#pragma once

#include "core/image.h"

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

namespace aoscore {

/// Reads one part of an image, strip by strip, and appends its channels: floats as they are, integers as
/// shares of their range. The channels are made when the first strip is there: a header alone, however large
/// its claims, takes no memory. Throws file_error for a part that is not whole.
void read_strips(OIIO::ImageInput& input, int subimage, const std::string& where,
                 std::vector<ImageF>& channels);

}  // namespace aoscore
