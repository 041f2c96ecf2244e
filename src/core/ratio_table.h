#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// What a benchmark has measured, a row a thing, each related to a baseline of the same run: machines are
/// shared and differ, so that a ratio says more than a number.
class RatioTable {
  public:
    /// A number by itself, or a baseline. Names are unique: throws internal_error.
    void add(const std::string& name, double value, const std::string& unit);
    /// The same, with its ratio to a row that is there already, of the same unit: throws internal_error.
    void add(const std::string& name, double value, const std::string& unit, const std::string& baseline);
    /// How many times the baseline's value; of a row that has one.
    double ratio(const std::string& name) const;

    /// All rows on standard output.
    void print() const;
    /// [{"name", "value", "unit", "baseline", "ratio"}]; the last two are null where there is no baseline.
    nlohmann::json json() const;

  private:
    struct Row {
        std::string name;
        double value;
        std::string unit;
        std::string baseline;  ///< a row's name; "" for none
        double ratio;
    };
    const Row& row(const std::string& name) const;
    bool holds(const std::string& name) const;

    std::vector<Row> rows_;
};

}  // namespace aoscore
