#include "report/stress_strips.h"

#include "core/error.h"
#include "report/base64.h"
#include "results/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

// Steps of a strip's colours; one more stands for what is no number. Odd, so that 0 has a colour of its own.
constexpr int kSteps = 15;
constexpr std::uint32_t kNoNumberColour = 0xff00ff;

using Palette = std::array<std::uint32_t, kSteps + 1>;

Palette between(const std::vector<std::array<double, 3>>& anchors) {
    Palette palette{};
    for (int i = 0; i < kSteps; ++i) {
        const double place = static_cast<double>(i) / (kSteps - 1) * static_cast<double>(anchors.size() - 1);
        const std::size_t low = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double value =
                std::lerp(anchors[low][channel], anchors[low + 1][channel], place - static_cast<double>(low));
            palette[static_cast<std::size_t>(i)] =
                palette[static_cast<std::size_t>(i)] << 8U | static_cast<std::uint32_t>(std::lround(value));
        }
    }
    palette[kSteps] = kNoNumberColour;
    return palette;
}

std::string picture_of(const std::vector<const ImageF*>& images, double low, double high,
                       const Palette& palette) {
    const int width = images.front()->width, height = images.front()->height;
    Image<std::uint8_t> codes(width, height * static_cast<int>(images.size()));
    std::size_t at = 0;
    for (const ImageF* image : images) {
        for (const float value : image->pixels) {
            const double place = (static_cast<double>(value) - low) / (high - low) * (kSteps - 1);
            codes.pixels[at++] =
                std::isfinite(value)
                    ? static_cast<std::uint8_t>(std::lround(std::clamp(place, 0.0, kSteps - 1.0)))
                    : static_cast<std::uint8_t>(kSteps);
        }
    }
    return "data:image/png;base64," + base64(encode_png_indexed(codes, palette));
}

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
    static const Palette gray = between({{0, 0, 0}, {255, 255, 255}});
    static const Palette blue_red =
        between({{5, 48, 97}, {67, 147, 195}, {247, 247, 247}, {214, 96, 77}, {103, 0, 31}});
    strip.visibility = picture_of(pictures, 0, 1, gray);
    strip.deviation = picture_of(differences, -kStressDeviationRange, kStressDeviationRange, blue_red);
    return strip;
}

}  // namespace aoscore
