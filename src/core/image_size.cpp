#include "core/image_size.h"

#include "core/error.h"
#include "core/image.h"
#include "core/strict_json.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace aoscore {
namespace {

bool is_side(double side) {
    return side == std::floor(side) && side >= 1 && side <= kLargestImageSide_px;
}

}  // namespace

ImageSize parse_image_size(const std::string& text, const std::string& where) {
    ImageSize size{0, 0};
    const char* const end = text.data() + text.size();
    const auto [x, width_error] = std::from_chars(text.data(), end, size.width);
    bool good = width_error == std::errc() && x != end && *x == 'x';
    if (good) {
        const auto [last, height_error] = std::from_chars(x + 1, end, size.height);
        good = height_error == std::errc() && last == end;
    }
    if (good && is_side(size.width) && is_side(size.height)) return size;
    throw usage_error(fmt::format("\"{}\" is no size", text), where,
                      fmt::format("such as 1920x1080, at most {} each way", kLargestImageSide_px));
}

ImageSize read_image_size(StrictObject& object) {
    const std::vector<double> sides = object.numbers("size", 2);
    for (const double side : sides) {
        if (is_side(side)) continue;
        throw file_error(fmt::format("holds {}", side), object.where("size"),
                         fmt::format("width and height in whole pixels, 1 to {}", kLargestImageSide_px));
    }
    return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

}  // namespace aoscore
