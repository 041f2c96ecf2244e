#include "metrics/intervals/over_views.h"

#include "core/error.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace aoscore {
namespace {

template <class Term>
double mean_of(std::span<const double> values, Term term) {
    double sum = 0;
    for (const double value : values) sum += term(value);
    return sum / static_cast<double>(values.size());
}

}  // namespace

double over_views::mean(std::span<const double> values) {
    return mean_of(values, [](double value) { return value; });
}

double over_views::root_mean_square(std::span<const double> values) {
    if (values.size() == 1) return values.front();
    return std::sqrt(mean_of(values, [](double value) { return value * value; }));
}

double over_views::decibels(std::span<const double> values) {
    if (values.size() == 1) return values.front();
    return -10 * std::log10(mean_of(values, [](double value) { return std::pow(10.0, -value / 10); }));
}

double over_views::largest(std::span<const double> values) {
    return *std::ranges::max_element(values);
}

double measure_over_views(std::string_view id, std::span<const double> values) {
    for (const Metric& metric : metrics()) {
        if (metric.id == id) return metric.over_views(values);
    }
    for (const MaskArea& area : mask_areas()) {
        if (area.id == id) return over_views::mean(values);
    }
    throw internal_error("no number over views of " + std::string(id));
}

}  // namespace aoscore
