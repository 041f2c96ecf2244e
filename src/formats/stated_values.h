#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// Throws file_error for values on a curve that no reading of this program takes off: film density and depth
/// by the transfer characteristic of a DPX, and Cineon, which is film density always.
void refuse_film(const OIIO::ImageSpec& spec, const std::string& where);

/// Throws file_error where the header states a factor of the values that is not above 0: the scale of a PFM,
/// EXPOSURE and COLORCORR of a Radiance picture.
void refuse_factors_of_none(const OIIO::ImageInput& input, const std::filesystem::path& path);

/// What the header says of its values that may make them other than they read, a sentence each: the curve of
/// a DPX for video, the scale of a PFM, the GAMMA of a Radiance picture.
std::vector<std::string> doubts_of(const OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                                   const std::filesystem::path& path);

}  // namespace aoscore
