#include "stress/stress_thumbnails.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {

ImageF stress_thumbnail(const ImageF& image, int steps) {
    const int width = std::min(image.width, kStressThumbnail_px),
              height = std::min(image.height, kStressThumbnail_px);
    ImageF small(width, height);
    for (int y = 0; y < height; ++y) {
        const int top = y * image.height / height, bottom = (y + 1) * image.height / height;
        for (int x = 0; x < width; ++x) {
            const int left = x * image.width / width, right = (x + 1) * image.width / width;
            double sum = 0;
            for (int v = top; v < bottom; ++v) {
                for (int u = left; u < right; ++u) sum += static_cast<double>(image.at(u, v));
            }
            const double mean = sum / ((bottom - top) * (right - left));
            small.at(x, y) = std::isfinite(mean) ? static_cast<float>(std::round(mean * steps) / steps)
                                                 : std::numeric_limits<float>::quiet_NaN();
        }
    }
    return small;
}

}  // namespace aoscore
