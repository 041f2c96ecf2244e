#include "tuning/objective.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/node_kind.h"
#include "jobs/draw_image.h"
#include "jobs/time_requests.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/median_interval.h"
#include "screen/method/request_digest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace aoscore {
namespace {

double loss_of(const Metric& metric, double value) {
    switch (metric.better) {
        case Metric::Better::lower:
            return value;
        case Metric::Better::higher:
            return 1 - value;
        case Metric::Better::nearer_zero:
            return std::abs(value);
    }
    return value;
}

/// The metric of a picture that is the truth itself, large enough for every metric.
MetricValue of_truth_itself(const Metric& metric) {
    constexpr int kSide_px = 256;
    const ImageF truth(kSide_px, kSide_px, 0.5F), no_error(kSide_px, kSide_px, 0.0F);
    const Mask valid(kSide_px, kSide_px, 1);
    const std::string id(metric.id);
    return evaluate({truth, truth, valid, &no_error}, std::vector{id}).at(id);
}

}  // namespace

void require_best_value(const Metric& metric) {
    const MetricValue best = of_truth_itself(metric);
    if (best.value) return;
    std::vector<std::string_view> valid;
    for (const Metric& other : metrics()) {
        if (of_truth_itself(other).value) valid.push_back(other.id);
    }
    throw usage_error(
        fmt::format("{} has no best value to tune towards: of the truth itself it is undefined, "
                    "since {}",
                    metric.label, best.note),
        "--metric", fmt::format("{}", fmt::join(valid, ", ")));
}

Objective::Objective(const TuningSubject& subject, const Registry& registry,
                     const std::vector<std::unique_ptr<TuningView>>& views, ScreenRenderer& renderer,
                     const ArtifactStore& store)
    : subject_(subject),
      metric_(metric(subject.metric)),
      fixed_pass_(registry.fixed_pass),
      views_(views),
      renderer_(renderer),
      store_(store) {
    for (const auto& view : views)
        cells_.push_back(resolve(subject.cell, registry, subject.seed, view->radius.metres));
}

std::vector<double> Objective::published() const {
    std::vector<double> values;
    for (const SearchAxis& axis : subject_.axes) values.push_back(axis.published);
    return values;
}

// Parameters are uniforms, so that one program serves all settings.
MethodRequest Objective::request_on(const std::vector<double>& settings, std::size_t view) const {
    MethodRequest request = cells_[view].request;
    request.uniform_form = true;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const SearchAxis& axis = subject_.axes[i];
        request.parameters[axis.parameter] = axis.on_view(settings[i], views_[view]->radius.metres);
    }
    return request;
}

template <class Measure>
double Objective::stored(const std::string& kind, const MethodRequest& request, std::size_t view,
                         const Measure& measure) {
    throw_if_interrupted();
    const TuningView& on = *views_[view];
    const bool orthographic = on.orthographic;
    const std::string key = KeyBuilder("tuning " + kind, "score")
                                .input(on.made_of)
                                .text(request_digest(request, orthographic))
                                .text(metric_.id)
                                .key()
                                .hex;
    if (const auto found = store_.find(key); found && found->is_number()) {
        ++reused_;
        return found->get<double>();
    }
    renderer_.use_gbuffer(on.gbuffer);
    const double value = measure();
    ++drawn_;
    store_.put(key, value);
    return value;
}

double Objective::measured_loss(const MethodRequest& request, std::size_t view) {
    const TuningView& on = *views_[view];
    const MethodOutput image = draw_image(renderer_, request);
    std::size_t nonfinite = 0;
    const Mask valid =
        finite_pixels(on.truth.visibility[0], image.visibility, on.ground.contract.valid, nonfinite);
    MetricInput input{on.truth.visibility[0], image.visibility, valid, &on.truth.standard_error[0]};
    const TruthHalves halves{on.truth.halves[0][0], on.truth.halves[0][1]};
    input.halves = &halves;
    const std::string id(metric_.id);
    const MetricValue value = evaluate(input, std::vector{id}).at(id);
    if (!value.value || nonfinite > 0) {
        throw Error(ExitCode::cells_failed,
                    on.key + ": " + request.method->id + " has no " + id + ": " +
                        (value.note.empty() ? "pixels are NaN or infinite" : value.note));
    }
    return loss_of(metric_, *value.value);
}

double Objective::loss(const std::vector<double>& settings, std::size_t view) {
    const auto [entry, is_new] = losses_.try_emplace({settings, view}, 0);
    if (!is_new) return entry->second;
    const MethodRequest request = request_on(settings, view);
    try {
        entry->second = stored("loss", request, view, [&] { return measured_loss(request, view); });
    } catch (...) {
        losses_.erase(entry);
        throw;
    }
    return entry->second;
}

double Objective::loss_over(const std::vector<double>& settings, const std::vector<std::size_t>& views) {
    std::vector<double> each;
    for (const std::size_t view : views) each.push_back(loss(settings, view));
    return metric_.over_views(each);
}

double Objective::fetches(const std::vector<double>& settings) {
    const auto found = fetches_.find(settings);
    if (found != fetches_.end()) return found->second;
    const MethodRequest request = request_on(settings, 0);
    const double count = stored("fetches", request, 0, [&] {
        return fetches_per_pixel(renderer_, request, views_[0]->ground.contract.valid);
    });
    return fetches_[settings] = count;
}

std::pair<double, double> Objective::timed(const std::vector<double>& settings) {
    MethodRequest request = request_on(settings, 0);
    request.uniform_form = false;
    MethodRequest fixed;
    fixed.method = &fixed_pass_;
    fixed.parameters = fixed_pass_.values("default");
    fixed.seed = subject_.seed;
    renderer_.use_gbuffer(views_[0]->gbuffer);
    const std::vector<RequestTimes> times =
        time_requests(renderer_, {{request}, {fixed}}, std::nullopt, "timing " + subject_.cell.method);
    for (const RequestTimes& one : times) {
        if (!one.error.empty()) throw Error(ExitCode::cells_failed, one.error, views_[0]->key);
    }
    double ms = median(times[0].ao.ms);
    if (!times[0].filter.ms.empty()) ms += median(times[0].filter.ms);
    return {ms, median(times[1].ao.ms)};
}

double Objective::timed_in_passes(const std::vector<double>& settings) {
    if (const auto found = passes_.find(settings); found != passes_.end()) return found->second;
    const TuningView& on = *views_[0];
    const std::string key = KeyBuilder("tuning times", "times")
                                .input(on.made_of)
                                .text(request_digest(request_on(settings, 0), on.orthographic))
                                .text(timed_on())
                                .key()
                                .hex;
    auto stored = store_.find(key);
    if (!stored) {
        require_times_here("--budget-ms");
        const auto [ms, fixed_ms] = timed(settings);
        stored = nlohmann::json{ms / fixed_ms, fixed_ms};
        store_.put(key, *stored);
    }
    // What all are related to must be the same again when a search goes on: the preset's.
    if (passes_.empty()) fixed_pass_ms_ = stored->at(1).get<double>();
    return passes_[settings] = stored->at(0).get<double>();
}

double Objective::milliseconds(const std::vector<double>& settings) {
    std::vector<double> whole = published();
    timed_in_passes(whole);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (subject_.axes[i].whole) whole[i] = settings[i];
    }
    return timed_in_passes(whole) * fixed_pass_ms_;
}

}  // namespace aoscore
