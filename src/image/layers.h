#pragma once

#include "image/channel_meaning.h"
#include "image/image_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace aoscore {

/// Channels of a file that make one picture: R, G and B of a layer, Y with its chroma RY and BY, X, Y and Z,
/// or one channel alone.
struct Layer {
    std::vector<std::size_t> channels;  ///< indices in the file; the first stands for all where they are grey
    ChannelMeaning meaning;
};

/// All channels of a file, each in one layer, in the file's order.
std::vector<Layer> layers_of(const ImageFile& file);

/// Whether a layer has one value a pixel: its channels are equal but for rounding, or have no chroma.
bool is_grey(const Layer& layer, const ImageFile& file);

}  // namespace aoscore
