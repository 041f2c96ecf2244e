#include "metrics/evaluate.h"

#include "core/known_names.h"
#include "metrics/mean_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

const Metric& metric(const std::string& id) {
    const auto found = std::ranges::find(metrics(), id, &Metric::id);
    if (found != metrics().end()) return *found;
    throw unknown_name("no metric", id, ids_of(metrics()));
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
    std::map<std::string, MetricValue> values;
    for (const Metric* row : rows) {
        values[std::string(row->id)] =
            nonfinite == 0 ? row->measure(input)
                           : undefined(fmt::format("{} valid pixels are NaN or infinite", nonfinite));
    }
    return values;
}

}  // namespace aoscore
