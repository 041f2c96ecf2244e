#include "core/ratio_table.h"

#include "core/error.h"
#include "core/output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace aoscore {

bool RatioTable::holds(const std::string& name) const {
    return std::ranges::find(rows_, name, &Row::name) != rows_.end();
}

const RatioTable::Row& RatioTable::row(const std::string& name) const {
    const auto found = std::ranges::find(rows_, name, &Row::name);
    if (found == rows_.end()) throw internal_error("no row of the benchmark is called " + name);
    return *found;
}

void RatioTable::add(const std::string& name, double value, const std::string& unit) {
    if (holds(name)) throw internal_error("two rows of the benchmark are called " + name);
    rows_.push_back({name, value, unit, "", 0});
}

void RatioTable::add(const std::string& name, double value, const std::string& unit,
                     const std::string& baseline) {
    const Row& beside = row(baseline);
    if (beside.unit != unit) throw internal_error(name + " has another unit than " + baseline);
    const double ratio = value / beside.value;
    add(name, value, unit);
    rows_.back().baseline = baseline;
    rows_.back().ratio = ratio;
}

double RatioTable::ratio(const std::string& name) const {
    if (row(name).baseline.empty()) throw internal_error(name + " has no baseline");
    return row(name).ratio;
}

void RatioTable::print() const {
    for (const Row& row : rows_) {
        const std::string beside =
            row.baseline.empty() ? "" : fmt::format("{:8.3g} x {}", row.ratio, row.baseline);
        print_result("{:<44} {:>10.4g} {:<22}{}\n", row.name, row.value, row.unit, beside);
    }
}

nlohmann::json RatioTable::json() const {
    nlohmann::json list = nlohmann::json::array();
    for (const Row& row : rows_) {
        const bool alone = row.baseline.empty();
        list.push_back({{"name", row.name},
                        {"value", row.value},
                        {"unit", row.unit},
                        {"baseline", alone ? nlohmann::json() : nlohmann::json(row.baseline)},
                        {"ratio", alone ? nlohmann::json() : nlohmann::json(row.ratio)}});
    }
    return list;
}

}  // namespace aoscore
