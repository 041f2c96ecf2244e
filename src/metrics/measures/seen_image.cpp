#include "metrics/measures/seen_image.h"

#include "core/threads.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/seen_rows.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aoscore {
namespace {

void keep(const SeenRow& row, const ImageArea& area, int y, SeenImage& seen) {
    const auto width = static_cast<std::size_t>(area.width);
    std::copy_n(row.lightness, width, &seen.lightness.at(area.left, y));
    std::copy_n(row.edges, width, &seen.edges.at(area.left, y));
    std::copy_n(row.points, width, &seen.points.at(area.left, y));
}

}  // namespace

SeenImage seen_image(const ImageF& image, const Mask& valid) {
    const int width = image.width, height = image.height;
    SeenImage seen{Image<double>(width, height), Image<double>(width, height), Image<double>(width, height)};
    const std::vector<ImageArea> areas = image_areas(image.width, image.height);
    parallel_for(areas.size(), [&](std::size_t i) {
        const ImageArea& area = areas[i];
        ValidRows valid_rows(valid, area);
        FilteredRows rows(image, valid_rows);
        for (int y = area.top; y < area.top + area.height; ++y) keep(rows.next(), area, y, seen);
    });
    return seen;
}

}  // namespace aoscore
