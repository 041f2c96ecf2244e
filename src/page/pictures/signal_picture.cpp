#include "page/pictures/signal_picture.h"

#include "page/document/base64.h"
#include "page/pictures/stored_images.h"
#include "page/pictures/thumbnail.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

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
    std::vector<ImageF> planes;
    for (const std::string_view channel : signal.channels)
        planes.push_back(shrunk(channel_of(file, path, std::string(channel)), width_px));
    if (planes.size() == 3) return direction_picture(planes);
    for (float& value : planes[0].pixels)
        value = static_cast<float>((static_cast<double>(value) - signal.low) / (signal.high - signal.low));
    return gray_thumbnail(planes[0], width_px);
}

}  // namespace aoscore
