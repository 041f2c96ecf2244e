#include "page/pictures/signal_picture.h"

#include "page/document/base64.h"
#include "page/pictures/coloured_picture.h"
#include "page/pictures/stored_images.h"
#include "page/pictures/thumbnail.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

constexpr double kAngleRange_deg = 45;
constexpr int kAngleShades = 63;

bool is_direction(const Signal& signal) {
    return signal.channels.size() == 3;
}

using Colour = std::array<std::uint8_t, 3>;

Colour colour_of(const glm::vec3& direction) {
    const float length = glm::length(direction);
    if (!(length > 0)) return {0, 0, 0};
    const glm::vec3 shade = 127.5F * (direction / length + 1.0F);
    return {static_cast<std::uint8_t>(std::lround(shade.x)), static_cast<std::uint8_t>(std::lround(shade.y)),
            static_cast<std::uint8_t>(std::lround(shade.z))};
}

Picture direction_picture(const std::vector<ImageF>& planes) {
    Image<Colour> colours(planes[0].width, planes[0].height);
    for (std::size_t i = 0; i < colours.size(); ++i)
        colours.pixels[i] = colour_of({planes[0].pixels[i], planes[1].pixels[i], planes[2].pixels[i]});
    return {"data:image/png;base64," + base64(encode_png_rgb(colours)), colours.width, colours.height};
}

}  // namespace

Picture signal_picture(const Signal& signal, const ImageFile& file, const std::filesystem::path& path,
                       int width_px) {
    SignalImage planes = signal_planes(signal, file, path);
    for (ImageF& plane : planes) plane = shrunk(plane, width_px);
    if (is_direction(signal)) return direction_picture(planes);
    for (float& value : planes[0].pixels)
        value = static_cast<float>((static_cast<double>(value) - signal.low) / (signal.high - signal.low));
    return gray_thumbnail(planes[0], width_px);
}

SignalImage signal_planes(const Signal& signal, const ImageFile& file, const std::filesystem::path& path) {
    SignalImage planes;
    for (const std::string_view channel : signal.channels)
        planes.push_back(channel_of(file, path, std::string(channel)));
    return planes;
}

SignalErrorRange signal_error_range(const Signal& signal) {
    return {is_direction(signal) ? 0 : -kAngleRange_deg, kAngleRange_deg};
}

Picture signal_error_picture(const Signal& signal, const SignalInput& input, int width_px) {
    const ImageF error = shrunk(angle_error_image(input), width_px);
    const auto [low, high] = signal_error_range(signal);
    Palette palette = is_direction(signal) ? magma_palette(kAngleShades) : blue_red_palette(kAngleShades);
    palette.back() = kNotComparedColour;
    return {coloured_picture({&error}, low, high, palette), error.width, error.height};
}

}  // namespace aoscore
