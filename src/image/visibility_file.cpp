#include "image/visibility_file.h"

#include "core/error.h"
#include "core/srgb.h"
#include "image/image_file.h"
#include "image/image_frame.h"
#include "image/png_coding.h"
#include "image/visibility_channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

Mask above_half(const ImageF& image) {
    Mask mask(image.width, image.height);
    std::ranges::transform(image.pixels, mask.pixels.begin(),
                           [](float value) { return static_cast<std::uint8_t>(value > 0.5F ? 1 : 0); });
    return mask;
}

/// Takes the standard error that belongs to a channel of visibility from the file: SE.Y for Y, SE1.Y for
/// V1.Y.
ImageF standard_error_of(ImageFile& file, const std::string& channel) {
    std::string name;
    if (channel == "Y" || channel.ends_with(".Y")) {
        const auto begin = channel.rfind('.', channel.size() - 3) + 1;
        const std::string layer = channel == "Y" ? "V" : channel.substr(begin, channel.size() - 2 - begin);
        const bool numbered = layer.find_first_not_of("0123456789", 1) == std::string::npos;
        if (layer.starts_with('V') && numbered)
            name = channel.substr(0, begin) + "SE" + layer.substr(1) + ".Y";
    }
    const std::optional<std::size_t> error = file.index(name);
    return error ? std::move(file.channels[*error]) : ImageF();
}

/// 1 where the file has a pixel for the channel, and mask.Y, if there is one, says that it shows a surface.
Mask mask_of(const ImageFile& file, std::size_t channel) {
    const auto found = std::ranges::find_if(file.channel_names, [](const std::string& name) {
        return name == "mask.Y" || name.ends_with(".mask.Y");
    });
    Mask mask = found == file.channel_names.end()
                    ? Mask(file.width, file.height, 1)
                    : above_half(file.channels[static_cast<std::size_t>(found - file.channel_names.begin())]);
    const PixelRect& covered = file.covered[channel];
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const bool inside = x >= covered.x && x < covered.x + covered.width && y >= covered.y &&
                                y < covered.y + covered.height;
            if (!inside) mask.at(x, y) = 0;
        }
    }
    return mask;
}

const char* name_of(Coding coding) {
    return coding == Coding::srgb ? "sRGB-coded" : "linear";
}

/// Integers mean two things: throws where it was not said which, and warns where the file says otherwise.
void check_coding(const std::optional<Coding>& asked, const std::filesystem::path& path,
                  std::vector<std::string>& warnings) {
    const std::optional<StatedCoding> stated = coding_stated_by_png(path);
    if (!asked) {
        throw usage_error(
            stated ? fmt::format("holds integers, which may be sRGB-coded or linear; its {} says {}",
                                 stated->by, stated->curve)
                   : "holds integers, which may be sRGB-coded or linear",
            path.string(), "--srgb, as pictures for the screen are, or --linear");
    }
    if (!stated || stated->coding == *asked) return;
    const char* remedy = !stated->coding                  ? "no option takes that off; export it linear"
                         : stated->coding == Coding::srgb ? "try --srgb"
                                                          : "try --linear";
    warnings.push_back(fmt::format("its {} says that its values are {}, and they are read as {}: {}",
                                   stated->by, stated->curve, name_of(*asked), remedy));
}

void decode_srgb(ImageF& image) {
    for (float& value : image.pixels)
        value = static_cast<float>(linear_from_srgb(static_cast<double>(value)));
}

void turn(VisibilityFile& file, const Orientation& orientation) {
    if (orientation.upright()) return;
    file.covered = shown(file.covered, file.visibility.width, file.visibility.height, orientation);
    file.visibility = shown(file.visibility, orientation);
    file.mask = shown(file.mask, orientation);
    file.standard_error = shown(file.standard_error, orientation);
}

}  // namespace

VisibilityFile read_visibility(const std::filesystem::path& path, const VisibilityReading& reading) {
    ImageFile file = read_image(path);
    const VisibilityChannel chosen = find_visibility(file, reading.channel, path.string());
    VisibilityFile result;
    result.channel = file.channel_names[chosen.index];
    result.why = chosen.why;
    if (!chosen.warning.empty()) result.warnings.push_back(result.channel + ": " + chosen.warning);
    result.covered = file.covered[chosen.index];
    result.integers = file.integers;
    result.warnings.insert(result.warnings.end(), file.doubts.begin(), file.doubts.end());
    if (file.integers) check_coding(reading.coding, path, result.warnings);
    result.mask = mask_of(file, chosen.index);
    result.visibility = std::move(file.channels[chosen.index]);
    if (reading.srgb_floats || (file.integers && reading.coding == Coding::srgb))
        decode_srgb(result.visibility);
    if (reading.invert) {
        for (float& value : result.visibility.pixels) value = 1 - value;
    }
    result.standard_error = standard_error_of(file, result.channel);
    turn(result, {.transposed = false, .mirrored = reading.mirror, .turned_over = reading.flip});
    return result;
}

Mask read_mask(const std::filesystem::path& path, const std::string& channel) {
    const ImageFile file = read_image(path);
    return above_half(file.channels[find_mask(file, channel, path.string())]);
}

}  // namespace aoscore
