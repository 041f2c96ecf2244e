#include "page/pictures/pictures.h"

#include "core/error.h"
#include "core/threads.h"
#include "page/pictures/lit_picture.h"
#include "page/pictures/signal_picture.h"
#include "page/pictures/stored_images.h"
#include "page/pictures/thumbnail.h"
#include "results/light_modes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr int kThumbnailWidth_px = 480;
// The number of values of visibility; at two bytes each they take at most 22 MB of a page.
constexpr std::size_t kSmallPage_values = 8'000'000;

void require_size(const ImageF& image, const ViewRecord& view, const fs::path& path) {
    if (image.width == view.width && image.height == view.height) return;
    throw file_error(fmt::format("is {}x{}", image.width, image.height), path.string(),
                     fmt::format("{}x{}, the size of view {}", view.width, view.height, view.key));
}

struct Truth {
    ImageFile file;
    ImageF visibility;
    ImageF standard_error;  ///< empty when the file has none
    Mask valid;
};

Truth read_truth(const ViewRecord& view, const fs::path& folder) {
    const fs::path path = stored_path(folder, view.truth_file);
    if (view.truths.empty()) throw file_error("has no truth", path.string() + ": " + view.key);
    const TruthRecord& record = view.truths.front();
    Truth truth;
    truth.file = read_image(path);
    const ImageFile& file = truth.file;
    truth.visibility = channel_of(file, path, record.channel);
    require_size(truth.visibility, view, path);
    if (const ImageF* error = file.channel(record.se_channel)) truth.standard_error = *error;
    const ImageF& mask = channel_of(file, path, "mask.Y");
    truth.valid = Mask(mask.width, mask.height);
    std::transform(mask.pixels.begin(), mask.pixels.end(), truth.valid.pixels.begin(),
                   [](float m) { return static_cast<std::uint8_t>(m > 0.5F); });
    return truth;
}

/// The value below which `part` of the valid pixels lie; 0 without any.
double quantile(const ImageF& values, const Mask& valid, double part) {
    std::vector<float> sorted;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (valid.pixels[i] != 0 && std::isfinite(values.pixels[i])) sorted.push_back(values.pixels[i]);
    }
    if (sorted.empty()) return 0;
    const auto place =
        sorted.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), place, sorted.end());
    return double{*place};
}

ImageF only_where(const ImageF& values, const Mask& valid) {
    ImageF kept = values;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (valid.pixels[i] == 0) kept.pixels[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return kept;
}

/// The common settings of all pictures of a page.
struct Encoding {
    int visibility_levels;
    bool extras;  ///< with raw outputs, and occlusion by cause
};

/// The encoding: a large page has fewer levels and no extras.
Encoding encoding_for(const Results& results, bool everything) {
    std::size_t values = 0;
    for (const ViewRecord& view : results.views) {
        const auto images =
            1 + std::count_if(results.cells.begin(), results.cells.end(), [&](const CellRecord& cell) {
                return cell.view_key == view.key && cell.error.empty();
            });
        values += static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height) *
                  static_cast<std::size_t>(images);
    }
    const bool small = values <= kSmallPage_values;
    return {small ? kLevelsOfTwoBytes : kLevelsOfOneByte, small || everything};
}

std::map<std::string, QuantisedImage> occlusion_pictures(const ViewRecord& view, const Truth& truth,
                                                         const fs::path& folder) {
    std::map<std::string, std::string> channels;
    for (const CauseRecord& cause : view.causes) channels[cause.id] = cause.channel;
    if (!view.one_layer_channel.empty()) channels["one_layer"] = view.one_layer_channel;
    std::map<std::string, QuantisedImage> pictures;
    for (const auto& [id, channel] : channels) {
        const ImageF& occlusion = channel_of(truth.file, stored_path(folder, view.truth_file), channel);
        pictures[id] = quantise(occlusion, 0, 1, kLevelsOfOneByte);
    }
    return pictures;
}

ViewPictures view_pictures(const ViewRecord& view, const Truth& truth, const Encoding& encoding,
                           const fs::path& folder) {
    ViewPictures pictures;
    pictures.truth = quantise(truth.visibility, 0, 1, encoding.visibility_levels);
    pictures.truth_thumbnail = gray_thumbnail(truth.visibility, kThumbnailWidth_px);
    pictures.has_standard_error = !truth.standard_error.empty();
    const ImageF error = pictures.has_standard_error ? truth.standard_error : ImageF(view.width, view.height);
    pictures.standard_error = quantise(only_where(error, truth.valid), 0, 0, kErrorLevels);
    if (encoding.extras) pictures.occlusion = occlusion_pictures(view, truth, folder);
    for (const SignalRecord& record : view.signals) {
        pictures.signals[record.id] = signal_picture(
            signal(record.id), truth.file, stored_path(folder, view.truth_file), kThumbnailWidth_px);
    }
    return pictures;
}

/// The view's traced irradiance.
struct TracedLight {
    ColourPlanes colours;
    ImageF luminance;
    double white = 1;  ///< what lit pictures show as white
};

std::optional<TracedLight> read_light(const ViewRecord& view, const Mask& valid, const fs::path& folder) {
    if (!view.light || view.light->file.empty()) return std::nullopt;
    const fs::path path = stored_path(folder, view.light->file);
    TracedLight light;
    light.colours = colour_planes(read_image(path), path, {"R", "G", "B"});
    require_size(light.colours[0], view, path);
    light.luminance = luminance_of(light.colours);
    // A pixel of a hundred is too bright, so that a few bright ones do not darken the picture.
    if (const double bright = quantile(largest_of(light.colours), valid, 0.99); bright > 0)
        light.white = bright;
    return light;
}

void add_lit(const CellRecord& cell, const ViewRecord& view, const Mask& valid, const TracedLight& light,
             const fs::path& folder, CellPictures& pictures) {
    if (cell.lit_file.empty()) return;
    const fs::path path = stored_path(folder, cell.lit_file);
    const ImageFile file = read_image(path);
    for (const LightMode& mode : light_modes()) {
        const std::string id(mode.id);
        if (!cell.light.contains(mode.error())) continue;
        const ColourPlanes colours = colour_planes(file, path, mode.channels());
        require_size(colours[0], view, path);
        pictures.lit[id] = lit_picture(colours, light.white, kThumbnailWidth_px);
        pictures.lit_errors[id] =
            lit_error_picture(colours, light.luminance, view.light->mean, valid, kThumbnailWidth_px);
    }
}

/// Reads the view's G-buffer, where it was kept.
void read_gbuffer(const ViewRecord& view, const Mask& valid, const fs::path& folder, const GBufferUse& use,
                  ViewPictures& pictures) {
    if (view.gbuffer_file.empty()) return;
    const fs::path path = stored_path(folder, view.gbuffer_file);
    const ImageFile file = read_image(path);
    const ImageF& depth = channel_of(file, path, "Z");
    require_size(depth, view, path);
    const double nearest = quantile(depth, valid, 0.0);
    pictures.depth_high_m = quantile(depth, valid, 0.99);
    if (use) pictures.depth_block = use(view, file, path);
    const auto encode = pictures.depth_block.empty() ? quantise : scale_for;
    pictures.depth = encode(only_where(depth, valid), nearest, nearest, kLevelsOfTwoBytes);
}

/// Adds the pictures of what the cell's image holds beside visibility.
void add_signals(const CellRecord& cell, const ViewRecord& view, const Truth& truth, const ImageFile& file,
                 const fs::path& folder, CellPictures& pictures) {
    const fs::path path = stored_path(folder, cell.image_file);
    const fs::path truth_path = stored_path(folder, view.truth_file);
    for (const auto& [id, unused] : cell.signals) {
        const Signal& row = signal(id);
        pictures.signals[id] = signal_picture(row, file, path, kThumbnailWidth_px);
        const SignalImage of_truth = signal_planes(row, truth.file, truth_path);
        const SignalImage of_cell = signal_planes(row, file, path);
        const ImageF* error = truth.file.channel(std::string(row.error_channel));
        if (error == nullptr) continue;  // which pixels count is not known
        pictures.signal_errors[id] =
            signal_error_picture(row, {of_truth, of_cell, truth.valid, *error}, kThumbnailWidth_px);
    }
}

/// Makes them, and shows the image to `use` before it is dropped.
CellPictures cell_pictures(const CellRecord& cell, const ViewRecord& view, const Truth& truth,
                           const Encoding& encoding, const fs::path& folder,
                           const std::function<void(const ImageF&)>& use) {
    const fs::path path = stored_path(folder, cell.image_file);
    const ImageFile file = read_image(path);
    const ImageF& output = channel_of(file, path, "Y");
    require_size(output, view, path);

    use(output);
    CellPictures pictures;
    pictures.output = quantise(output, 0, 1, encoding.visibility_levels);
    pictures.output_thumbnail = gray_thumbnail(output, kThumbnailWidth_px);
    if (const ImageF* raw = file.channel("raw.Y")) {
        if (encoding.extras) pictures.raw = quantise(*raw, 0, 1, encoding.visibility_levels);
        pictures.raw_thumbnail = gray_thumbnail(*raw, kThumbnailWidth_px);
    }
    add_signals(cell, view, truth, file, folder, pictures);
    return pictures;
}

}  // namespace

Pictures make_pictures(const Results& results, const fs::path& folder, bool everything,
                       const GBufferUse& use) {
    const Encoding encoding = encoding_for(results, everything);
    const int look_px = first_look_width_px(results.views.size());
    Pictures pictures;
    for (const ViewRecord& view : results.views) {
        const Truth truth = read_truth(view, folder);
        const std::optional<TracedLight> light = read_light(view, truth.valid, folder);
        FirstLook look = first_look(view, truth.visibility, look_px);
        const CellRecord* const at_first = first_cell(results, view.key);
        ViewPictures& of_view = pictures.views[view.key];
        std::vector<std::function<void()>> jobs;
        jobs.emplace_back([&] {
            of_view = view_pictures(view, truth, encoding, folder);
            read_gbuffer(view, truth.valid, folder, use, of_view);
            if (!light) return;
            of_view.irradiance = lit_picture(light->colours, light->white, kThumbnailWidth_px);
            of_view.irradiance_white = light->white;
        });
        for (const CellRecord& cell : results.cells) {
            if (cell.view_key != view.key || !cell.error.empty()) continue;
            CellPictures& of_cell = pictures.cells[cell.id];
            jobs.emplace_back([&] {
                of_cell = cell_pictures(cell, view, truth, encoding, folder, [&](const ImageF& output) {
                    if (&cell == at_first)
                        show_cell(look, cell, truth.visibility, output, truth.valid, look_px);
                });
                if (light) add_lit(cell, view, truth.valid, *light, folder, of_cell);
            });
        }
        parallel_for(jobs.size(), [&](std::size_t i) { jobs[i](); });
        pictures.looks.push_back(std::move(look));
    }
    return pictures;
}

}  // namespace aoscore
