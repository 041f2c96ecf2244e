#include "metrics/evaluate.h"

#include "core/known_names.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/measures/mean_error.h"
#include "metrics/prepared_image.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

MetricValue measured(const Metric& row, const MetricInput& input) {
    const MetricValue whole = row.measure(input);
    if (input.halves == nullptr || row.noise != Metric::Noise::extrapolated) return whole;
    return extrapolated(whole, row.measure(against_half(input, 0)), row.measure(against_half(input, 1)));
}

}  // namespace

const Metric& metric(std::string_view id) {
    return row_of(metrics(), id, "no metric");
}

std::vector<std::string> unranked_metrics() {
    std::vector<std::string> ids;
    for (const Metric& row : metrics()) {
        if (row.unranked) ids.emplace_back(row.id);
    }
    return ids;
}

std::vector<std::string> told_metrics(double noise_variance, std::span<const std::string> ids) {
    std::vector<std::string> told;
    for (const Metric& row : metrics()) {
        if (!ids.empty() && std::ranges::find(ids, row.id) == ids.end()) continue;
        if (row.left_by_variance * noise_variance <= 1) told.emplace_back(row.id);
    }
    return told;
}

std::map<std::string, MetricValue> evaluate(const MetricInput& input, std::span<const std::string> ids) {
    require_one_size(input);
    std::vector<const Metric*> rows;
    for (const std::string& id : ids) rows.push_back(&metric(id));
    if (ids.empty()) {
        for (const Metric& row : metrics()) rows.push_back(&row);
    }

    std::size_t nonfinite = 0;
    finite_pixels(input.truth, input.test, input.valid, nonfinite);
    const PreparedImage test(input.test, input.valid);
    MetricInput shared = input;
    // Against a single truth each metric reads the image once, so that storing its preparation would only
    // cost memory.
    if (input.halves != nullptr && input.prepared_test == nullptr) shared.prepared_test = &test;
    std::map<std::string, MetricValue> values;
    for (const Metric* row : rows) {
        values[std::string(row->id)] =
            nonfinite == 0 ? measured(*row, shared)
                           : undefined(fmt::format("{} valid pixels are NaN or infinite", nonfinite));
    }
    return values;
}

}  // namespace aoscore
