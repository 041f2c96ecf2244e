#include "page/pictures/first_look.h"

#include "page/pictures/coloured_picture.h"
#include "page/pictures/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

constexpr int kWide_px = 640, kNarrow_px = 320, kIcon_px = 96;
/// With more views than this their pictures are narrow, so that many views do not make a large page.
constexpr std::size_t kFewViews = 4;
constexpr int kGrayShades = 127, kErrorShades = 63;
/// A smaller cut-out shows no more than a few large squares.
constexpr double kLeastCut_px = 32;

std::string gray(const ImageF& visibility, int width_px) {
    const ImageF small = shrunk(visibility, width_px);
    return coloured_picture({&small}, 0, 1, gray_palette(kGrayShades));
}

std::string signed_error(const ImageF& truth, const ImageF& output, const Mask& valid, int width_px) {
    ImageF error(truth.width, truth.height, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < error.size(); ++i) {
        if (valid.pixels[i] != 0) error.pixels[i] = output.pixels[i] - truth.pixels[i];
    }
    const ImageF small = shrunk(error, width_px);
    Palette palette = blue_red_palette(kErrorShades);
    palette.back() = kNotComparedColour;
    return coloured_picture({&small}, -kFirstLookRange, kFirstLookRange, palette);
}

const ErrorRegion* worst_of(const CellRecord& cell) {
    if (!cell.analysis || cell.analysis->regions.empty()) return nullptr;
    const auto summed = [](const ErrorRegion& region) {
        return std::abs(region.mean_error) * static_cast<double>(region.area_px);
    };
    return &*std::ranges::max_element(cell.analysis->regions, {}, summed);
}

/// Places the cut-out: the region with as much around it, half as wide as the picture's own shape, but no
/// more than a third of the picture, around the region's worst pixel.
void place_cut(FirstLook& look, const ImageF& image, const ErrorRegion& region) {
    const double shape = 0.5 * image.width / image.height, most = image.height / 3.0;
    const double least = std::max(kLeastCut_px, kLeastCut_px / shape);
    const double tall = std::max({2.0 * region.height, 2.0 * region.width / shape, least});
    look.cut_height =
        std::clamp(static_cast<int>(std::lround(std::min(tall, std::max(most, least)))), 1, image.height);
    look.cut_width = std::clamp(static_cast<int>(std::lround(look.cut_height * shape)), 1, image.width);
    const bool whole = region.width <= look.cut_width && region.height <= look.cut_height;
    const int x = whole ? region.left + region.width / 2 : region.worst_x;
    const int y = whole ? region.top + region.height / 2 : region.worst_y;
    look.cut_left = std::clamp(x - look.cut_width / 2, 0, image.width - look.cut_width);
    look.cut_top = std::clamp(y - look.cut_height / 2, 0, image.height - look.cut_height);
}

std::string cut_out(const FirstLook& look, const ImageF& image, int width_px) {
    ImageF cut(look.cut_width, look.cut_height);
    for (int y = 0; y < cut.height; ++y) {
        for (int x = 0; x < cut.width; ++x) cut.at(x, y) = image.at(look.cut_left + x, look.cut_top + y);
    }
    return gray(cut, width_px / 2);
}

}  // namespace

const CellRecord* first_cell(const Results& results, const std::string& view_key) {
    const CellRecord* bound = nullptr;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key != view_key || !cell.error.empty()) continue;
        if (cell.role != kBoundRole) return &cell;
        if (bound == nullptr) bound = &cell;
    }
    return bound;
}

int first_look_width_px(std::size_t views) {
    return views <= kFewViews ? kWide_px : kNarrow_px;
}

FirstLook first_look(const ViewRecord& view, const ImageF& truth, int width_px) {
    FirstLook look;
    look.view_key = view.key;
    look.icon = gray(truth, kIcon_px);
    look.truth = gray(truth, width_px);
    return look;
}

void show_cell(FirstLook& look, const CellRecord& cell, const ImageF& truth, const ImageF& output,
               const Mask& valid, int width_px) {
    look.cell_id = cell.id;
    look.output = gray(output, width_px);
    look.error = signed_error(truth, output, valid, width_px);
    const ErrorRegion* const worst = worst_of(cell);
    if (worst == nullptr) return;
    look.worst = *worst;
    place_cut(look, truth, *worst);
    look.worst_truth = cut_out(look, truth, width_px);
    look.worst_output = cut_out(look, output, width_px);
}

}  // namespace aoscore
