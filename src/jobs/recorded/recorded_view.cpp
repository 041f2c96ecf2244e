#include "jobs/recorded/recorded_view.h"

#include "core/hash.h"
#include "jobs/pixel_facts.h"
#include "jobs/recorded/given_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace aoscore {
namespace {

// Below this a radius covers no tap's distance; above it, most taps leave the picture.
constexpr double kLeastRadius_px = 1;

void add_image(const ImageF& image, Digest& digest) {
    digest.value(image.width).value(image.height).array(std::span(image.pixels));
}

std::string digest_of(const RecordedView& view) {
    Digest digest;
    for (const auto& [id, image] : view.gbuffer.numbers) add_image(image, digest.text(id));
    for (const auto& [id, image] : view.gbuffer.vectors) digest.text(id).array(std::span(image.pixels));
    add_image(view.truth.visibility[0], digest);
    add_image(view.truth.standard_error[0], digest);
    digest.value(view.truth.halves.empty());
    return digest.array(std::span(view.valid.pixels)).hex();
}

/// Warns where radius and depth can hardly be of one unit.
void doubt_radius(const RecordedView& view, const CameraFrame& frame, std::vector<std::string>& warnings) {
    std::vector<double> radii_px;
    for (std::size_t i = 0; i < view.valid.size(); ++i) {
        if (view.valid.pixels[i] != 0)
            radii_px.push_back(view.radius_m *
                               frame.pixels_per_metre(double{view.gbuffer.linear_depth().pixels[i]}));
    }
    const auto middle = radii_px.begin() + static_cast<std::ptrdiff_t>(radii_px.size() / 2);
    std::nth_element(radii_px.begin(), middle, radii_px.end());
    if (*middle >= kLeastRadius_px && *middle <= 4.0 * view.height) return;
    warnings.push_back(fmt::format(
        "a radius of {:g} m is {:.3g} pixels at the median depth of a picture {} pixels high: the "
        "depth may be in another unit (\"unit\" in the camera file)",
        view.radius_m, *middle, view.height));
}

}  // namespace

std::set<std::string> RecordedView::channels() const {
    std::set<std::string> ids;
    for (const auto& [id, image] : gbuffer.numbers) ids.insert(id);
    for (const auto& [id, image] : gbuffer.vectors) ids.insert(id);
    return ids;
}

RecordedView read_recorded_view(const FrameRequest& request, const GivenTruthRequest& truth,
                                const std::string& name) {
    FrameFile file = read_frame(request);
    RecordedView view;
    view.width = file.frame.width();
    view.height = file.frame.height();
    view.gbuffer = std::move(file.images);
    view.read_as = std::move(file.read_as);
    read_given_truth(truth, view, file.warnings);
    doubt_radius(view, file.frame, file.warnings);
    auto scene = std::make_shared<Scene>();
    scene->id = name;
    scene->file = request.files.front();
    scene->digest = digest_of(view);
    scene->warnings = std::move(file.warnings);
    View& of_frame = scene->views.emplace_back();
    of_frame.id = "frame";
    of_frame.camera = file.frame.camera();
    of_frame.radius_m = view.radius_m;
    of_frame.source = request.files.front().string();
    of_frame.note = view.read_as;
    view.scene = std::move(scene);
    return view;
}

Ground recorded_ground(const CameraFrame& frame, const RecordedView& view) {
    Ground ground{{}, pixel_facts(frame, view.truth)};
    ground.contract.valid = view.valid;
    for (std::size_t i = 0; i < view.valid.size(); ++i) {
        ground.contract.surface += view.gbuffer.surface.pixels[i];
        ground.contract.valid_count += view.valid.pixels[i];
    }
    return ground;
}

}  // namespace aoscore
