#include "verdict/gates.h"

#include "core/error.h"
#include "core/known_names.h"
#include "metrics/metric.h"

#include <fmt/format.h>

#include <iterator>

namespace aoscore {

Gates::Limits Gates::parse(const std::vector<std::string>& texts, bool has_baseline) {
    Limits limits;
    for (const std::string& text : texts) {
        if (text != kWorse) {
            limits.gates.push_back(Gate::parse(text));
            continue;
        }
        if (!has_baseline)
            throw usage_error("there is nothing to be worse than", text, "--baseline RESULTS.json");
        limits.worse = true;
    }
    return limits;
}

Gates::Gates(const std::vector<std::string>& fail, const std::vector<std::string>& warn, bool has_baseline)
    : fail_(parse(fail, has_baseline)), warn_(parse(warn, has_baseline)) {}

void Gates::require_above_noise(double noise_floor_rmse, const std::string& where) const {
    for (const Limits* limits : {&fail_, &warn_}) {
        for (const Gate& gate : limits->gates) {
            const bool upper =
                gate.relation == Gate::Relation::greater || gate.relation == Gate::Relation::greater_equal;
            const Metric* row = find_row(metrics(), gate.metric);
            const bool noisy = row != nullptr && !row->without_noise.empty();
            if (!upper || !noisy || gate.threshold >= noise_floor_rmse) continue;
            throw usage_error(
                fmt::format("{} is below the noise of the truth, {:.6g}", gate.text, noise_floor_rmse), where,
                fmt::format("a higher threshold, a truth of more samples, or {}", row->without_noise));
        }
    }
}

Gates::Tripped Gates::check(const MetricMap& measures, const std::set<std::string>& measured_of_some) const {
    const auto lines = [&](const Limits& limits) {
        std::vector<std::string> tripped;
        for (const Gate& gate : limits.gates) {
            if (gate.judges(measures, measured_of_some) && gate.tripped_by(measures))
                tripped.push_back(gate.explain(measures));
        }
        return tripped;
    };
    return {lines(fail_), lines(warn_)};
}

std::vector<std::string> Gates::not_judging(const MetricMap& measures,
                                            const std::set<std::string>& measured_of_some) const {
    std::vector<std::string> texts;
    for (const Limits* limits : {&fail_, &warn_}) {
        for (const Gate& gate : limits->gates) {
            if (!gate.judges(measures, measured_of_some)) texts.push_back(gate.text);
        }
    }
    return texts;
}

Gates::Tripped Gates::check(const ChangeRecord& change) const {
    Tripped tripped;
    // A cell that can no longer be compared with its earlier one may hide a change for the worse.
    const bool untold = change.verdict == "not comparable" && change.before;
    if (change.verdict != "worse" && !untold) return tripped;
    const std::string line =
        untold          ? "whether it is worse cannot be told: " + change.reason
        : change.change ? fmt::format(
                              "worse: {} went from {:.6g} to {:.6g}; the change is between {:.3g} and "
                              "{:.3g} with 95 % confidence",
                              change.metric, change.before.value_or(0), change.now.value_or(0),
                              change.change->low, change.change->high)
                        : "worse: " + change.reason;
    if (fail_.worse) tripped.failures.push_back(line);
    if (warn_.worse) tripped.warnings.push_back(line);
    return tripped;
}

ExitCode Gates::Tripped::exit_code() const {
    if (!failures.empty()) return ExitCode::gate_failed;
    return warnings.empty() ? ExitCode::ok : ExitCode::warned;
}

void Gates::Tripped::add(const Tripped& other) {
    failures.insert(failures.end(), other.failures.begin(), other.failures.end());
    warnings.insert(warnings.end(), other.warnings.begin(), other.warnings.end());
}

}  // namespace aoscore
