#include "jobs/repeats.h"

#include "jobs/truth_signals.h"
#include "metrics/signal_metric.h"
#include "results/record_json.h"
#include "results/results_members.h"
#include "screen/method/depth_layers.h"
#include "screen/method/request_digest.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr std::string_view kHiddenCause = "hidden", kGrazingCause = "grazing";

MethodRequest changed(MethodRequest request, const ParameterValues& changes) {
    for (const auto& [id, value] : changes) request.parameters[id] = value;
    return request;
}

/// The pictures of a request for each of the seeds.
std::vector<MethodOutput> drawn_with_seeds(ScreenRenderer& renderer, MethodRequest request) {
    std::vector<MethodOutput> pictures;
    for (int i = 0; i < Repeats::kSeeds; ++i) {
        pictures.push_back(renderer.run(request));
        ++request.seed;
    }
    return pictures;
}

std::vector<ImageF> planes(std::vector<MethodOutput>& pictures, ImageF MethodOutput::*plane) {
    std::vector<ImageF> images;
    for (MethodOutput& picture : pictures) images.push_back(std::move(picture.*plane));
    return images;
}

ImageF mean_occlusion(ScreenRenderer& renderer, MethodRequest request) {
    request.filter = nullptr;
    request.signals.clear();
    std::vector<MethodOutput> pictures = drawn_with_seeds(renderer, std::move(request));
    ImageF mean = mean_image(planes(pictures, &MethodOutput::raw));
    for (float& v : mean.pixels) v = 1 - v;
    return mean;
}

/// What the request's estimator finds over all layers, and what of it over the first alone it does not. Null
/// for a method without layers, and for one whose layers cannot be chosen.
const HiddenOcclusion* hidden_by_first_layer(ScreenRenderer& renderer, const MethodRequest& request,
                                             LayersDrawn& drawn) {
    const auto first = first_layer_alone(*request.method);
    const auto all = all_layers(*request.method);
    if (!first || !all) return nullptr;
    const MethodRequest of_first = changed(request, *first);
    // Members that have no effect on what is drawn must not divide what can be shared.
    const MethodRequest of_all = changed(of_first, *all);
    const std::string digest = request_digest(of_first, false) + request_digest(of_all, false);
    if (drawn.by_digest.size() == LayersDrawn::kMost) drawn.by_digest.clear();
    const auto [entry, is_new] = drawn.by_digest.try_emplace(digest);
    HiddenOcclusion& occlusion = entry->second;
    if (!is_new) return &occlusion;
    const ImageF over_first = mean_occlusion(renderer, of_first);
    occlusion.whole = mean_occlusion(renderer, of_all);
    occlusion.hidden = occlusion.whole;
    for (std::size_t i = 0; i < over_first.size(); ++i) occlusion.hidden.pixels[i] -= over_first.pixels[i];
    return &occlusion;
}

/// The truth's occlusion and the part of it that has this cause; empty where it was traced without causes.
std::optional<HiddenOcclusion> part_of_truth(const Truth& truth, const Ground& ground,
                                             std::string_view name) {
    const auto& causes = ground.facts.causes;
    const auto cause = std::ranges::find(causes, name, &PixelFacts::Cause::name);
    if (cause == causes.end()) return std::nullopt;
    HiddenOcclusion occlusion{truth.visibility[0], *cause->occlusion};
    for (float& v : occlusion.whole.pixels) v = 1 - v;
    return occlusion;
}

/// The valid pixels that `counts(i)` picks.
template <class Counts>
Mask part_of(const Mask& valid, Counts counts) {
    Mask part = valid;
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (!counts(i)) part.pixels[i] = 0;
    }
    return part;
}

void measure_signals(const MethodOutput& picture, const Truth& truth, const HiddenOcclusion& occlusion,
                     const Mask& valid, Repeats& repeats) {
    const Mask hidden = part_of(valid, [&](std::size_t i) { return occlusion.is_hidden(i); });
    const Mask visible = part_of(valid, [&](std::size_t i) { return occlusion.is_visible(i); });
    for (const auto& [id, image] : picture.signals) {
        const TruthSignal known = truth_signal(truth, id);
        const SignalInput where_hidden{known.image, image, hidden, *known.standard_error_rad};
        const SignalInput elsewhere{known.image, image, visible, *known.standard_error_rad};
        repeats.hidden_signals[id] = evaluate_signal(id, where_hidden);
        repeats.other_signals[id] = evaluate_signal(id, elsewhere);
        repeats.hidden_angles[id] = angle_blocks(where_hidden);
        repeats.other_angles[id] = angle_blocks(elsewhere);
    }
}

}  // namespace

Repeats repeat_image(ScreenRenderer& renderer, const RepeatRequest& asked, const Truth& truth,
                     const Ground& ground, LayersDrawn& drawn) {
    const MethodRequest& request = asked.request;
    const Mask& valid = ground.contract.valid;
    const HiddenOcclusion* of_layers = hidden_by_first_layer(renderer, request, drawn);
    const std::optional<HiddenOcclusion> of_truth = part_of_truth(truth, ground, kHiddenCause);
    const std::optional<HiddenOcclusion> of_grazing = part_of_truth(truth, ground, kGrazingCause);
    std::vector<MethodOutput> pictures = drawn_with_seeds(renderer, request);
    Repeats repeats;
    if (of_truth) measure_signals(pictures.front(), truth, *of_truth, valid, repeats);
    const std::vector<ImageF> raw = planes(pictures, &MethodOutput::raw);
    const std::vector<ImageF> filtered = planes(pictures, &MethodOutput::visibility);
    repeats.counts = valid_counts(valid);
    repeats.variance = variance_sums(filtered, valid);
    repeats.raw_variance = variance_sums(raw, valid);
    const ImageF mean = mean_image(filtered);
    if (of_truth) repeats.of_truth = found_occlusion(*of_truth, mean, valid, Findings::within_hidden);
    if (of_grazing) repeats.of_grazing = found_occlusion(*of_grazing, mean, valid, Findings::within_hidden);
    if (asked.converged) {
        std::vector<MethodOutput> converged = drawn_with_seeds(renderer, *asked.converged);
        repeats.raw_from_converged =
            convergence(raw, mean_image(planes(converged, &MethodOutput::raw)), valid);
        repeats.from_converged =
            convergence(filtered, mean_image(planes(converged, &MethodOutput::visibility)), valid);
    }
    if (of_layers != nullptr)
        repeats.of_layers = found_occlusion(*of_layers, mean_image(raw), valid, Findings::free);
    return repeats;
}

nlohmann::json to_json(const Repeats& repeats) {
    return record_json::checked_json(repeats, "repeats");
}

Repeats repeats_from_json(const nlohmann::json& json, const std::string& where) {
    return record_json::record_from_json<Repeats>(json, where);
}

}  // namespace aoscore
