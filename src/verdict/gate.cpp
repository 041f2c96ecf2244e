#include "verdict/gate.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/text.h"
#include "metrics/intervals/bootstrap.h"
#include "metrics/metric.h"
#include "metrics/signal_metric.h"
#include "results/light_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

// Longer signs first, so that ">=" is not read as ">".
constexpr std::array<std::pair<const char*, Gate::Relation>, 4> kRelations{{
    {">=", Gate::Relation::greater_equal},
    {"<=", Gate::Relation::less_equal},
    {">", Gate::Relation::greater},
    {"<", Gate::Relation::less},
}};

constexpr const char* kForm = "a metric, one of > >= < <=, a number: rmse>0.02";

std::string light_id(const std::string& measure) {
    return std::string(kLightPrefix) + measure;
}

const MeasuredMetric* find(const MetricMap& metrics, const std::string& id) {
    const auto found = metrics.find(id);
    return found != metrics.end() && found->second.value ? &found->second : nullptr;
}

/// Of a signal beside visibility, or of light, which not every method gives.
bool is_of_some_methods(const std::string& id) {
    return id.starts_with(kLightPrefix) ||
           std::ranges::any_of(signal_metrics(), [&](const SignalMetric& row) { return row.id == id; });
}

}  // namespace

std::vector<std::string> limited_ids() {
    std::vector<std::string> ids = ids_of(metrics());
    for (const MaskArea& area : mask_areas()) ids.emplace_back(area.id);
    for (const SignalMetric& metric : signal_metrics()) ids.emplace_back(metric.id);
    for (const LightMode& mode : light_modes()) {
        for (const std::string& id : mode.measures()) ids.push_back(light_id(id));
    }
    return ids;
}

MetricMap limited_measures(const CellRecord& cell) {
    MetricMap measures = limited_measures(cell.ranked, cell.analysis);
    for (const auto& [signal, metrics] : cell.signals) {
        for (const auto& [id, value] : metrics) measures[id] = value;
    }
    for (const auto& [id, measure] : cell.light) measures[light_id(id)] = {measure.value, ""};
    return measures;
}

MetricMap limited_measures(const MetricMap& metrics, const std::optional<ErrorAnalysis>& analysis) {
    MetricMap measures = metrics;
    for (const SignalMetric& metric : signal_metrics()) {
        measures[std::string(metric.id)].note = fmt::format(
            "it is measured by score --signals {}, of methods that give that signal", metric.signal);
    }
    for (const LightMode& mode : light_modes()) {
        for (const std::string& id : mode.measures())
            measures[light_id(id)].note =
                "it is measured by score --environment, of methods with its signals";
    }
    if (!analysis) return measures;
    for (const MaskArea& area : mask_areas()) measures[std::string(area.id)].value = area.value(*analysis);
    return measures;
}

Gate Gate::parse(const std::string& text) {
    for (const auto& [sign, relation] : kRelations) {
        const auto at = text.find(sign);
        if (at == std::string::npos) continue;
        const std::string measure = trimmed(text.substr(0, at));
        const std::string number = trimmed(text.substr(at + std::strlen(sign)));
        Gate gate{measure, relation, 0, measure + sign + number};
        char* end = nullptr;
        gate.threshold = std::strtod(number.c_str(), &end);
        if (number.empty() || *end != '\0' || !std::isfinite(gate.threshold)) {
            throw usage_error("\"" + number + "\" is no number", text, kForm);
        }
        const std::vector<std::string> known = limited_ids();
        if (std::ranges::find(known, measure) == known.end())
            throw unknown_name("no metric", measure, known, text);
        return gate;
    }
    throw usage_error("no limit", text, kForm);
}

bool Gate::judges(const MetricMap& metrics, const std::set<std::string>& measured_of_some) const {
    return find(metrics, metric) != nullptr || !is_of_some_methods(metric) ||
           !measured_of_some.contains(metric);
}

bool Gate::tripped_by(const MetricMap& metrics) const {
    const MeasuredMetric* measured = find(metrics, metric);
    if (measured == nullptr) return true;
    const double value = *measured->value;
    switch (relation) {
        case Relation::greater:
            return !(value <= threshold);
        case Relation::greater_equal:
            return !(value < threshold);
        case Relation::less:
            return !(value >= threshold);
        case Relation::less_equal:
            return !(value > threshold);
    }
    return true;
}

std::string Gate::explain(const MetricMap& metrics) const {
    const MeasuredMetric* measured = find(metrics, metric);
    if (measured == nullptr) {
        const auto found = metrics.find(metric);
        return fmt::format(
            "{}: {} has no value{}", text, metric,
            found != metrics.end() && !found->second.note.empty() ? " (" + found->second.note + ")" : "");
    }
    return fmt::format("{}: {} is {:.6g}; {} would have passed", text, metric, *measured->value,
                       passing(*measured->value).text);
}

Gate Gate::passing(double value) const {
    const bool upper = relation == Relation::greater || relation == Relation::greater_equal;
    const auto sign =
        std::ranges::find(kRelations, relation, &std::pair<const char*, Relation>::second)->first;
    // The nearest limit of few digits that holds, however the digits of the value continue.
    const double step = value == 0 ? 1e-6 : std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
    const double nearest = upper ? std::ceil(value / step) : std::floor(value / step);
    for (int steps = 0;; ++steps) {
        Gate gate = *this;
        gate.text = fmt::format("{}{}{:.6g}", metric, sign, (nearest + (upper ? steps : -steps)) * step);
        gate.threshold = std::strtod(gate.text.c_str() + gate.text.find(sign) + std::strlen(sign), nullptr);
        if (!gate.tripped_by({{metric, {value, ""}}})) return gate;
    }
}

}  // namespace aoscore
