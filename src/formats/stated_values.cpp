#include "formats/stated_values.h"

#include "core/error.h"
#include "image/radiance_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

namespace aoscore {
namespace {

constexpr const char* kTransfer = "dpx:Transfer";

// Names of OpenImageIO for transfer characteristics of DPX (SMPTE 268M).
constexpr std::array<std::string_view, 5> kNoBrightness = {"Printing density", "Logarithmic", "ADX",
                                                           "Z depth linear", "Z depth homogeneous"};
constexpr std::array<std::string_view, 4> kNoCurve = {"", "User defined", "Linear", "Undefined"};

/// The third word of a PFM: its sign is the byte order, its magnitude the scale. 1 where it is no number.
float pfm_scale(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string kind;
    int width = 0, height = 0;
    float scale = 1;
    in >> kind >> width >> height >> scale;
    const bool pfm = kind == "PF" || kind == "Pf";
    return in && pfm ? std::abs(scale) : 1;
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
