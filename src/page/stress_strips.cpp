#include "page/stress_strips.h"

#include "core/error.h"
#include "image/image_file.h"
#include "page/pictures/coloured_picture.h"

#include <algorithm>
#include <vector>

namespace aoscore {
namespace {

// The number of colours of a strip, which is odd so that 0 has a colour of its own.
constexpr int kSteps = 15;

const ImageF& channel_of(const ImageFile& file, const std::string& name, const std::string& where) {
    const ImageF* image = file.channel(name);
    if (image == nullptr) throw file_error("has no channel " + name, where);
    return *image;
}

}  // namespace

StressStrip make_stress_strip(const StressSettingRecord& setting, const std::filesystem::path& folder) {
    if (setting.images.empty()) return {};
    const std::filesystem::path relative(setting.images);
    const bool inside = relative.is_relative() && std::none_of(relative.begin(), relative.end(),
                                                               [](const auto& part) { return part == ".."; });
    if (!inside) throw file_error("names images outside of its folder", "stress.json: " + setting.images);
    const std::filesystem::path path = folder / relative;
    const ImageFile file = read_image(path);
    StressStrip strip;
    std::vector<const ImageF*> pictures, differences;
    const ImageF none(file.width, file.height, 0);
    for (const StressCell& cell : setting.cells) {
        if (!cell.skipped.empty() || !cell.error.empty()) continue;
        strip.places[cell.subject] = static_cast<int>(pictures.size());
        pictures.push_back(&channel_of(file, cell.subject + ".Y", path.string()));
        const ImageF* difference = file.channel(cell.subject + ".D");
        differences.push_back(difference != nullptr ? difference : &none);
    }
    if (pictures.empty()) return strip;
    strip.width = file.width;
    strip.height = file.height;
    strip.visibility = coloured_picture(pictures, 0, 1, gray_palette(kSteps));
    strip.deviation = coloured_picture(differences, -kStressDeviationRange, kStressDeviationRange,
                                       blue_red_palette(kSteps));
    return strip;
}

}  // namespace aoscore
