#include "jobs/recorded/given_truth.h"

#include "core/error.h"
#include "image/image_file.h"
#include "reference/halved_truth.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace aoscore {
namespace {

/// The radius that this program's own truth files state for a channel: "V1.Y" has that of query 1.
std::optional<double> stated_radius_m(const std::filesystem::path& path, const std::string& channel) {
    const std::string query = channel.starts_with('V') ? channel.substr(0, channel.find('.')) : "V0";
    const ImageFile file = read_image(path);
    const auto found = file.attributes.find("aoscore:" + query + ".radius_m");
    if (found == file.attributes.end()) return std::nullopt;
    double radius_m = 0;
    const std::string& text = found->second;
    const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), radius_m);
    return ec == std::errc() && radius_m > 0 ? std::optional(radius_m) : std::nullopt;
}

double radius_of(const GivenTruthRequest& request, const std::string& channel) {
    const std::optional<double> stated = stated_radius_m(request.file, channel);
    if (request.radius_m && stated && std::abs(*stated - *request.radius_m) > 1e-6 * *stated)
        throw usage_error(
            fmt::format("is {:g} m, and the truth was traced at {:g} m", *request.radius_m, *stated),
            "--radius", "the radius of the truth");
    if (request.radius_m) return *request.radius_m;
    if (stated) return *stated;
    throw usage_error("the truth does not say at which radius it was traced", request.file.string(),
                      "--radius R, in metres: how far its rays reach");
}

VisibilityFile read_sized(const std::filesystem::path& path, const VisibilityReading& reading,
                          const RecordedView& view) {
    VisibilityFile file = read_visibility(path, reading);
    if (file.visibility.width == view.width && file.visibility.height == view.height) return file;
    throw Error(ExitCode::sizes_differ,
                fmt::format("is {}x{}, and the frame {}x{}", file.visibility.width, file.visibility.height,
                            view.width, view.height),
                path.string(), "images of one size");
}

void restrict_to(const VisibilityFile& file, Mask& valid) {
    for (std::size_t i = 0; i < valid.size(); ++i) valid.pixels[i] &= file.mask.pixels[i];
}

void require_finite(const VisibilityFile& file, const Mask& valid, const std::filesystem::path& path) {
    std::size_t count = 0, nonfinite = 0, beyond = 0;
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (valid.pixels[i] == 0) continue;
        ++count;
        const float value = file.visibility.pixels[i];
        nonfinite += !std::isfinite(value);
        beyond += value < -0.01F || value > 1.01F;
    }
    if (count == 0)
        throw Error(ExitCode::gate_failed, "frame and truth show a surface through no common pixel",
                    path.string());
    if (nonfinite > 0)
        throw file_error(fmt::format("{} pixels of {} are NaN or infinite", nonfinite, count), path.string(),
                         "a visibility in every pixel that shows a surface");
    if (2 * beyond > count)
        throw file_error(fmt::format("{} of {} values lie outside of 0 to 1", beyond, count), path.string(),
                         "visibility, 1 where nothing occludes; or occlusion, with --invert-truth");
}

/// Visibility is 1 where there is no surface, as in truths that were traced here.
void open_background(ImageF& visibility, const Mask& valid) {
    for (std::size_t i = 0; i < valid.size(); ++i) {
        if (valid.pixels[i] == 0) visibility.pixels[i] = 1;
    }
}

Truth truth_of(VisibilityFile file, const RecordedView& view) {
    Truth truth;
    truth.queries = {{Falloff::binary, view.radius_m, 0}};
    truth.hits = {view.gbuffer.surface, view.gbuffer.linear_depth(), view.gbuffer.vector("normal_geometric")};
    open_background(file.visibility, view.valid);
    truth.visibility = {std::move(file.visibility)};
    truth.standard_error = {std::move(file.standard_error)};
    truth.sample_counts = Image<std::uint32_t>(view.width, view.height);
    return truth;
}

// Half the difference of two independent renderings estimates the standard error of their mean, without
// bias for its square.
void error_by_difference(Truth& first, const Truth& second) {
    ImageF error(first.visibility[0].width, first.visibility[0].height);
    for (std::size_t i = 0; i < error.size(); ++i)
        error.pixels[i] = std::abs(first.visibility[0].pixels[i] - second.visibility[0].pixels[i]) / 2;
    first.halves = {{first.visibility[0], second.visibility[0]}};
    for (std::size_t i = 0; i < error.size(); ++i)
        first.visibility[0].pixels[i] = (first.halves[0][0].pixels[i] + first.halves[0][1].pixels[i]) / 2;
    first.standard_error = {std::move(error)};
}

}  // namespace

void read_given_truth(const GivenTruthRequest& request, RecordedView& view,
                      std::vector<std::string>& warnings) {
    VisibilityFile first = read_sized(request.file, request.reading, view);
    warnings.insert(warnings.end(), first.warnings.begin(), first.warnings.end());
    view.radius_m = radius_of(request, first.channel);
    view.read_as +=
        fmt::format("; truth {} of {} ({})", first.channel, request.file.filename().string(), first.why);
    view.valid = view.gbuffer.surface;
    restrict_to(first, view.valid);
    std::optional<VisibilityFile> second;
    if (!request.second.empty()) {
        second = read_sized(request.second, request.reading, view);
        restrict_to(*second, view.valid);
        require_finite(*second, view.valid, request.second);
        if (second->visibility.pixels == first.visibility.pixels)
            throw file_error("is the same picture as " + request.file.string(), request.second.string(),
                             "a rendering with other random numbers");
    }
    require_finite(first, view.valid, request.file);
    view.truth = truth_of(std::move(first), view);
    if (second) {
        error_by_difference(view.truth, truth_of(std::move(*second), view));
        view.read_as +=
            fmt::format("; its noise by a second rendering, {}", request.second.filename().string());
    } else if (view.truth.standard_error[0].empty()) {
        warnings.push_back(
            "the truth's standard error is unknown: its noise is part of every error, nothing is debiased, "
            "and "
            "there is no noise floor; a second rendering with other random numbers tells it (--truth-again)");
    }
}

}  // namespace aoscore
