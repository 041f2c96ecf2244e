#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace aoscore {

/// What the header of a Radiance picture says of its values.
struct RadianceHeader {
    /// By how much red, green and blue were multiplied since they were visibility: the product of the lines
    /// EXPOSURE= and COLORCORR=, which programs append to (Ward, pcomb of Radiance, divides by both for the
    /// original); 1 without one.
    std::array<float, 3> factors{1, 1, 1};
    std::string wrong_factor;  ///< the first of these lines whose numbers are not all finite and above 0
    float gamma = 1;           ///< the exponent of a line GAMMA=, which some programs write
    std::string format;        ///< 32-bit_rle_rgbe or 32-bit_rle_xyze; empty without the line
};

/// Reads it as far as it goes; all defaults for a file of another format.
RadianceHeader read_radiance_header(const std::filesystem::path& path);

}  // namespace aoscore
