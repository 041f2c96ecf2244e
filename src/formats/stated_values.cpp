#include "formats/stated_values.h"

#include "core/error.h"
#include "image/radiance_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>

namespace aoscore {
namespace {

constexpr const char* kTransfer = "dpx:Transfer";

// Names of OpenImageIO for transfer characteristics of DPX (SMPTE 268M).
constexpr std::array<std::string_view, 5> kNoBrightness = {"Printing density", "Logarithmic", "ADX",
                                                           "Z depth linear", "Z depth homogeneous"};
constexpr std::array<std::string_view, 4> kNoCurve = {"", "User defined", "Linear", "Undefined"};

/// The third word of a PFM: its sign is the byte order, its magnitude the scale. 1 where the header ends
/// before it.
float pfm_scale(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string kind;
    int width = 0, height = 0;
    std::string word;
    in >> kind >> width >> height >> word;
    const bool pfm = kind == "PF" || kind == "Pf";
    if (!in || !pfm) return 1;
    // Streams do not read nan and inf, which the library multiplies by.
    return std::abs(std::strtof(word.c_str(), nullptr));
}

}  // namespace

void refuse_film(const OIIO::ImageSpec& spec, const std::string& where) {
    const std::string transfer(spec.get_string_attribute(kTransfer));
    const bool film = spec.get_string_attribute("oiio:ColorSpace") == "KodakLog";
    if (!film && std::ranges::find(kNoBrightness, transfer) == kNoBrightness.end()) return;
    throw file_error(fmt::format("holds values that are not linear: its header says {}",
                                 transfer.empty() ? "film density" : transfer),
                     where, "a linear export, such as EXR");
}

void refuse_factors_of_none(const OIIO::ImageInput& input, const std::filesystem::path& path) {
    const std::string_view format = input.format_name();
    if (format == "pnm") {
        const float scale = pfm_scale(path);
        if (!(scale > 0) || std::isinf(scale))
            throw file_error("its header's scale, by which its values are multiplied, is 0 or no number",
                             path.string(), "-1, or 1 where the bytes are big-endian");
    }
    if (format != "hdr") return;
    if (const RadianceHeader header = read_radiance_header(path); !header.wrong_factor.empty())
        throw file_error(
            fmt::format("its header says {}, by which its values were multiplied", header.wrong_factor),
            path.string(), "an EXPOSURE of one number above 0, a COLORCORR of three");
}

std::vector<std::string> doubts_of(const OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                                   const std::filesystem::path& path) {
    std::vector<std::string> doubts;
    const std::string transfer(spec.get_string_attribute(kTransfer));
    if (std::ranges::find(kNoCurve, transfer) == kNoCurve.end()) {
        doubts.push_back(
            fmt::format("its header says that its values have the curve of video {}, which no option takes "
                        "off: export it "
                        "linear",
                        transfer));
    }
    const std::string_view format = input.format_name();
    if (const float scale = format == "pnm" ? pfm_scale(path) : 1; scale != 1) {
        doubts.push_back(
            fmt::format("its header's scale is {:g}, by which its values are multiplied: a scale of 1 "
                        "or -1 leaves them as they are",
                        scale));
    }
    if (const float gamma = format == "hdr" ? read_radiance_header(path).gamma : 1; gamma != 1) {
        doubts.push_back(fmt::format(
            "its header says GAMMA={:g}, a curve that no option takes off: export it linear", gamma));
    }
    return doubts;
}

}  // namespace aoscore
