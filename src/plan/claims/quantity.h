#pragma once

#include "results/results.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// A number with draws of other values that repeating its measurement could have given. Expressions are
/// evaluated draw by draw, so that they have an interval too.
struct Measured {
    std::optional<double> value;
    std::vector<double> draws;  ///< empty: the value is exact

    struct Range {
        double low = 0, high = 0;
    };
    /// The middle 95 % of the draws, or the value itself; empty without a value or where a draw is not
    /// finite.
    std::optional<Range> range() const;
};

/// A value without uncertainty.
Measured exact(std::optional<double> value);

/// Applies f to the values, and to each of their draws. Empty where one of them is, or f is not finite.
Measured combined(const std::vector<Measured>& of,
                  const std::function<double(const std::vector<double>&)>& f);

/// What a cell must be measured for beside its score and its fetches.
struct QuantityNeeds {
    bool times = false;               ///< the times of its passes
    bool lighting = false;            ///< and that of the lighting pass of its view
    bool whole_frames = false;        ///< and times of whole frames, which are lit
    bool repeats = false;             ///< drawn again with other seeds
    bool causes = false;              ///< and held against the truth's causes
    bool converged = false;           ///< and against its own converged picture
    bool lit_by_environment = false;  ///< its light held against ray-traced irradiance
    bool regional = false;            ///< it may be measured over a part of the picture
    std::string_view signal{};        ///< a signal beside visibility; empty: none

    bool lit() const { return lighting || whole_frames; }
    bool timed() const { return times || lit(); }
};

/// A quantity that is measured of a cell.
struct Quantity {
    std::string_view id;     ///< "ao_ms"
    std::string_view label;  ///< "AO pass"
    std::string_view unit;
    int decimals = 2;
    Measured (*measure)(const CellRecord& cell, const ViewRecord& view, std::uint64_t seed);
    QuantityNeeds needs = {};
};
/// The one table of quantities.
const std::vector<Quantity>& quantities();
/// The quantity of this id. Throws file_error at `where` that lists the known ids.
const Quantity& find_quantity(std::string_view id, const std::string& where);

}  // namespace aoscore
