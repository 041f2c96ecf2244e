#include "metrics/evaluate.h"

#include "core/known_names.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/measures/shared_sums.h"
#include "metrics/prepared_halves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace aoscore {
namespace {

/// An image against a truth and, where it has two halves, against either. The halves must be prepared.
class Evaluation {
  public:
    explicit Evaluation(const MetricInput& input) {
        inputs_.push_back(input);
        if (input.halves != nullptr) {
            inputs_[0].prepared_truth = &input.halves->prepared->whole;
            for (const std::size_t half : {0U, 1U}) inputs_.push_back(against_half(input, half));
        }
        shared_.resize(inputs_.size());
        for (std::size_t i = 0; i < inputs_.size(); ++i) inputs_[i].shared = &shared_[i];
    }

    /// Whether all valid pixels of the image and of the truth are finite: no sum of squares of floats is too
    /// large.
    bool finite() const { return std::isfinite(difference_sums(inputs_[0]).squared); }

    MetricValue measured(const Metric& row) const {
        const MetricValue whole = row.measure(inputs_[0]);
        if (inputs_.size() == 1 || row.noise != Metric::Noise::extrapolated) return whole;
        return extrapolated(whole, row.measure(inputs_[1]), row.measure(inputs_[2]));
    }

  private:
    std::vector<MetricInput> inputs_;
    std::vector<SharedSums> shared_;
};

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
        if (row.part_left(noise_variance) <= 1 && noise_variance <= row.most_noise_variance)
            told.emplace_back(row.id);
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

    const PreparedImage test(input.test, input.valid);
    MetricInput shared = input;
    std::optional<TruthHalves> halves;
    std::optional<PreparedHalves> prepared;
    if (input.halves != nullptr && input.halves->prepared == nullptr) {
        halves.emplace(*input.halves);
        halves->prepared = &prepared.emplace(input.truth, halves->first, halves->second, input.valid);
        shared.halves = &*halves;
    }
    // Against a single truth each metric reads the image once, so that storing its preparation would only
    // cost memory.
    if (input.halves != nullptr && input.prepared_test == nullptr) shared.prepared_test = &test;
    const Evaluation evaluation(shared);
    const std::size_t nonfinite =
        evaluation.finite() ? 0 : nonfinite_pixels(input.truth, input.test, input.valid);
    std::map<std::string, MetricValue> values;
    for (const Metric* row : rows) {
        values[std::string(row->id)] =
            nonfinite == 0 ? evaluation.measured(*row)
                           : undefined(fmt::format("{} valid pixels are NaN or infinite", nonfinite));
    }
    return values;
}

}  // namespace aoscore
