#include "compare/comparison.h"

#include "compare/picture_doubts.h"
#include "core/error.h"
#include "core/threads.h"
#include "image/image_frame.h"
#include "metrics/evaluate.h"
#include "metrics/measures/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <utility>

namespace aoscore {
namespace {

template <class T>
Image<T> cropped(const Image<T>& image, const PixelRect& crop) {
    Image<T> result(crop.width, crop.height);
    for (int y = 0; y < crop.height; ++y) {
        const T* from = &image.at(crop.x, crop.y + y);
        std::copy(from, from + crop.width, &result.at(0, y));
    }
    return result;
}

void crop_file(VisibilityFile& file, const PixelRect& crop) {
    const PixelRect& covered = file.covered;
    file.covered = within_frame({covered.x - crop.x, covered.y - crop.y, covered.width, covered.height},
                                crop.width, crop.height);
    file.visibility = cropped(file.visibility, crop);
    file.mask = cropped(file.mask, crop);
    if (!file.standard_error.empty()) file.standard_error = cropped(file.standard_error, crop);
}

bool lies_within(const PixelRect& crop, const ImageF& image) {
    return crop.width >= 1 && crop.height >= 1 && crop.x >= 0 && crop.y >= 0 &&
           crop.width <= image.width - crop.x && crop.height <= image.height - crop.y;
}

template <class T>
std::string size_text(const Image<T>& image) {
    return fmt::format("{}x{}", image.width, image.height);
}

template <class T>
void require_size(const ImageF& truth, const Image<T>& image, const char* name,
                  const std::filesystem::path& path) {
    if (image.same_size(truth)) return;
    throw Error(ExitCode::sizes_differ,
                fmt::format("truth is {}, {} is {}", size_text(truth), name, size_text(image)), path.string(),
                "images of one size");
}

struct Pair {
    VisibilityFile truth, test;
    Mask candidate;  ///< pixels within all masks
    bool in_whole;   ///< whether both images are their files' whole frames
};

/// Reads both files at once. Where neither can be read, it is the truth's error that is thrown.
Pair read_files(const ComparisonRequest& request) {
    Pair pair{{}, {}, {}, true};
    std::exception_ptr errors[2];
    parallel_for(std::size(errors), [&](std::size_t i) {
        try {
            (i == 0 ? pair.truth : pair.test) = i == 0 ? read_visibility(request.truth, request.truth_reading)
                                                       : read_visibility(request.test, request.test_reading);
        } catch (...) {
            errors[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& error : errors) {
        if (error) std::rethrow_exception(error);
    }
    return pair;
}

Pair read_pair(const ComparisonRequest& request) {
    Pair pair = read_files(request);
    Mask mask;
    if (!request.mask.empty()) {
        mask = read_mask(request.mask, request.mask_channel);
        require_size(pair.truth.visibility, mask, "the mask", request.mask);
    }
    if (request.crop) {
        const PixelRect& crop = *request.crop;
        if (!lies_within(crop, pair.truth.visibility)) {
            throw usage_error(fmt::format("{}x{} pixels at {}, {} are not within the truth", crop.width,
                                          crop.height, crop.x, crop.y),
                              "--crop", "a part of " + size_text(pair.truth.visibility));
        }
        pair.in_whole = !pair.test.visibility.same_size(pair.truth.visibility);
        if (!pair.in_whole) crop_file(pair.test, crop);
        crop_file(pair.truth, crop);
        if (!mask.empty()) mask = cropped(mask, crop);
    }
    require_size(pair.truth.visibility, pair.test.visibility, "test", request.test);
    pair.candidate = pair.truth.mask;
    for (std::size_t i = 0; i < pair.candidate.size(); ++i) {
        pair.candidate.pixels[i] &= pair.test.mask.pixels[i];
        if (!mask.empty()) pair.candidate.pixels[i] &= mask.pixels[i];
    }
    return pair;
}

/// Warns where a file has no pixels for a part of its picture, which then does not count.
void add_gaps(const VisibilityFile& file, const char* name, std::vector<std::string>& warnings) {
    const PixelRect& covered = file.covered;
    if (covered == PixelRect{0, 0, file.visibility.width, file.visibility.height}) return;
    warnings.push_back(
        fmt::format("{} holds {}x{} pixels at {}, {} of the {} compared: the others do not count", name,
                    covered.width, covered.height, covered.x, covered.y, size_text(file.visibility)));
}

std::vector<std::string> warnings_of(const Pair& pair, const ComparisonRequest& request) {
    std::vector<std::string> warnings = pair.truth.warnings;
    warnings.insert(warnings.end(), pair.test.warnings.begin(), pair.test.warnings.end());
    add_gaps(pair.truth, "the truth", warnings);
    add_gaps(pair.test, "the test", warnings);
    const std::vector<std::string> doubts =
        picture_doubts(pair.truth, pair.test, pair.candidate, request.test_reading, pair.in_whole);
    warnings.insert(warnings.end(), doubts.begin(), doubts.end());
    return warnings;
}

/// Warns of a threshold of 0, see mask_totals(), and of one within the noise.
void add_noise_in_areas(const MetricInput& input, double threshold, std::vector<std::string>& warnings) {
    if (input.standard_error == nullptr) return;
    const double noise = std::sqrt(mean_noise_variance(input).value_or(0));
    if (threshold > 0 && threshold < noise)
        warnings.push_back(fmt::format(
            "the --mask-threshold of {:.3g} is below the truth's noise, {:.3g} in the mean square: the areas "
            "of "
            "missing and false occlusion are uncertain, and below half of the noise nothing is stated of how "
            "much; more rays or a larger threshold tell them",
            threshold, noise));
    if (threshold > 0) return;
    warnings.push_back(
        "beyond a --mask-threshold of 0 every difference counts, also one by the truth's noise: how sure the "
        "areas of missing and false occlusion are is not known");
}

void add_smallness(const std::optional<ErrorAnalysis>& analysis, std::vector<std::string>& warnings) {
    if (!analysis) return;
    if (std::string why = why_no_intervals(analysis->blocks); !why.empty())
        warnings.push_back(std::move(why));
}

nlohmann::json json_of(const MeasuredMetric& metric) {
    nlohmann::json object = {{"value", metric.value ? nlohmann::json(*metric.value) : nlohmann::json()}};
    if (!metric.note.empty()) object["note"] = metric.note;
    return object;
}

}  // namespace

Comparison compare_images(const ComparisonRequest& request) {
    Pair pair = read_pair(request);
    Comparison result;
    result.request = request;
    result.truth_channel = pair.truth.channel;
    result.test_channel = pair.test.channel;
    result.truth_channel_why = pair.truth.why;
    result.test_channel_why = pair.test.why;
    result.warnings = warnings_of(pair, request);
    pair.truth.mask = pair.test.mask = {};
    result.truth = std::move(pair.truth.visibility);
    result.test = std::move(pair.test.visibility);
    result.width = result.truth.width;
    result.height = result.truth.height;
    result.valid = finite_pixels(result.truth, result.test, pair.candidate, result.nonfinite);
    pair.candidate = {};
    for (const auto pixel : result.valid.pixels) result.valid_pixels += pixel;
    MapSums maps;
    const MetricInput input{result.truth, result.test, result.valid,
                            pair.truth.standard_error.empty() ? nullptr : &pair.truth.standard_error, &maps};
    result.metrics = evaluate(input);
    if (input.standard_error != nullptr) result.noise = noise_floor(*input.standard_error, result.valid);
    result.analysis = analyse(input, {}, request.mask_threshold, request.seed);
    add_smallness(result.analysis, result.warnings);
    add_noise_in_areas(input, request.mask_threshold, result.warnings);
    return result;
}

nlohmann::json to_json(const Comparison& comparison) {
    const ComparisonRequest& request = comparison.request;
    nlohmann::json metrics = nlohmann::json::object();
    for (const auto& [id, metric] : comparison.metrics) metrics[id] = json_of(metric);
    nlohmann::json masks = {{"threshold", request.mask_threshold}};
    for (const MaskArea& area : mask_areas()) {
        masks[std::string(area.id)] =
            comparison.analysis ? nlohmann::json(area.value(*comparison.analysis)) : nlohmann::json();
    }
    return {
        {"truth", request.truth.string()},
        {"truth_channel", comparison.truth_channel},
        {"truth_channel_why", comparison.truth_channel_why},
        {"test", request.test.string()},
        {"test_channel", comparison.test_channel},
        {"test_channel_why", comparison.test_channel_why},
        {"warnings", comparison.warnings},
        {"width", comparison.width},
        {"height", comparison.height},
        {"valid_pixels", comparison.valid_pixels},
        {"nonfinite", comparison.nonfinite},
        {"noise_floor_rmse", comparison.noise ? nlohmann::json(comparison.noise->rmse()) : nlohmann::json()},
        {"metrics", metrics},
        {"masks", masks},
        {"analysis", comparison.analysis ? to_json(*comparison.analysis) : nlohmann::json()}};
}

}  // namespace aoscore
