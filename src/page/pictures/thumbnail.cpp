#include "page/pictures/thumbnail.h"

#include "image/image_file.h"
#include "page/document/base64.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

ImageF shrunk(const ImageF& image, int width_px) {
    const int factor = std::max(1, (image.width + width_px - 1) / width_px);
    if (factor == 1) return image;
    ImageF small((image.width + factor - 1) / factor, (image.height + factor - 1) / factor);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            float sum = 0, count = 0;
            for (int v = y * factor; v < std::min((y + 1) * factor, image.height); ++v) {
                for (int u = x * factor; u < std::min((x + 1) * factor, image.width); ++u) {
                    sum += image.at(u, v);
                    count += 1;
                }
            }
            small.at(x, y) = sum / count;
        }
    }
    return small;
}

Picture gray_thumbnail(const ImageF& visibility, int width_px) {
    const ImageF means = shrunk(visibility, width_px);
    Image<std::uint8_t> small(means.width, means.height);
    std::ranges::transform(means.pixels, small.pixels.begin(), [](float mean) {
        return mean > 0 ? static_cast<std::uint8_t>(std::lround(std::min(mean, 1.0F) * 255)) : 0;
    });
    return {"data:image/png;base64," + base64(encode_png_gray(small)), small.width, small.height};
}

}  // namespace aoscore
