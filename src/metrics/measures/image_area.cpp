#include "metrics/measures/image_area.h"

#include <algorithm>

namespace aoscore {
namespace {

constexpr int kWidth_px = 256, kHeight_px = 256;

}  // namespace

std::vector<ImageArea> image_areas(int width, int height) {
    std::vector<ImageArea> areas;
    for (int y = 0; y < height; y += kHeight_px) {
        for (int x = 0; x < width; x += kWidth_px)
            areas.push_back({x, y, std::min(kWidth_px, width - x), std::min(kHeight_px, height - y)});
    }
    return areas;
}

}  // namespace aoscore
