#include "report/thumbnail.h"

#include "report/base64.h"
#include "results/image_file.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

Picture gray_thumbnail(const ImageF& visibility, int width_px) {
    const int factor = std::max(1, (visibility.width + width_px - 1) / width_px);
    Image<std::uint8_t> small((visibility.width + factor - 1) / factor,
                              (visibility.height + factor - 1) / factor);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            float sum = 0, count = 0;
            for (int v = y * factor; v < std::min((y + 1) * factor, visibility.height); ++v) {
                for (int u = x * factor; u < std::min((x + 1) * factor, visibility.width); ++u) {
                    sum += visibility.at(u, v);
                    count += 1;
                }
            }
            const float mean = sum / count;
            small.at(x, y) =
                mean > 0 ? static_cast<std::uint8_t>(std::lround(std::min(mean, 1.0F) * 255)) : 0;
        }
    }
    return {"data:image/png;base64," + base64(encode_png_gray(small)), small.width, small.height};
}

}  // namespace aoscore
