#include "metrics/measures/mean_error.h"

#include "core/error.h"
#include "core/threads.h"
#include "metrics/measures/shared_sums.h"
#include "metrics/measures/wide_lanes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

AOSCORE_WIDER_WHERE_POSSIBLE
DifferenceSums sums_of_row(const float* truth, const float* test, const std::uint8_t* valid,
                           std::size_t count) {
    Lanes counts{}, signed_sums{}, absolutes{}, squares{};
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        Lanes one = Lanes{} + 1.0, of_truth, error;
        load(of_truth, truth + i);
        load(error, test + i);
        error -= of_truth;
        replace_invalid(error, valid + i);
        replace_invalid(one, valid + i);
        counts += one;
        signed_sums += error;
        squares += error * error;
        take_sign_off(error);
        absolutes += error;
    }
    DifferenceSums sums{sum_of(counts), sum_of(signed_sums), sum_of(absolutes), sum_of(squares)};
    for (; i < count; ++i) {
        if (valid[i] == 0) continue;
        const double error = double{test[i]} - double{truth[i]};
        sums.add({1, error, std::abs(error), error * error});
    }
    return sums;
}

/// Calls row(index of its first pixel) for each row on all cores, and adds their sums in order.
template <class Row>
DifferenceSums sums_of_rows(const Mask& valid, Row row) {
    std::vector<DifferenceSums> rows(static_cast<std::size_t>(valid.height));
    parallel_for(rows.size(),
                 [&](std::size_t y) { rows[y] = row(y * static_cast<std::size_t>(valid.width)); });
    DifferenceSums all;
    for (const DifferenceSums& each : rows) all.add(each);
    return all;
}

std::optional<double> mean(double sum, const DifferenceSums& sums) {
    return sums.count > 0 ? std::optional(sum / sums.count) : std::nullopt;
}

}  // namespace

MetricValue defined(double value, std::string note) {
    if (!std::isfinite(value)) return undefined(kNotFinite);
    return {value, std::move(note)};
}

MetricValue undefined(std::string why) {
    return {std::nullopt, std::move(why)};
}

void require_one_size(const MetricInput& input) {
    const auto require = [&](const auto& image, const char* name) {
        if (image.same_size(input.truth)) return;
        throw Error(ExitCode::sizes_differ,
                    fmt::format("{} is {}x{}, but the truth is {}x{}", name, image.width, image.height,
                                input.truth.width, input.truth.height),
                    {}, "images of one size");
    };
    require(input.test, "the test image");
    require(input.valid, "the mask");
    if (input.standard_error != nullptr) require(*input.standard_error, "the standard error");
}

bool has_valid_pixel(const MetricInput& input) {
    require_one_size(input);
    return std::ranges::any_of(input.valid.pixels, [](std::uint8_t valid) { return valid != 0; });
}

DifferenceSums difference_sums(const MetricInput& input) {
    require_one_size(input);
    if (input.shared != nullptr && input.shared->differences) return *input.shared->differences;
    const DifferenceSums sums = sums_of_rows(input.valid, [&](std::size_t first) {
        return sums_of_row(input.truth.pixels.data() + first, input.test.pixels.data() + first,
                           input.valid.pixels.data() + first, static_cast<std::size_t>(input.valid.width));
    });
    if (input.shared != nullptr) input.shared->differences = sums;
    return sums;
}

DifferenceSums value_sums(const ImageF& values, const Mask& valid) {
    require_one_size({values, values, valid});
    const std::vector<float> zeros(static_cast<std::size_t>(valid.width));
    return sums_of_rows(valid, [&](std::size_t first) {
        return sums_of_row(zeros.data(), values.pixels.data() + first, valid.pixels.data() + first,
                           zeros.size());
    });
}

std::optional<double> mean_error(const MetricInput& input) {
    const DifferenceSums sums = difference_sums(input);
    return mean(sums.signed_sum, sums);
}

std::optional<double> mean_absolute_error(const MetricInput& input) {
    const DifferenceSums sums = difference_sums(input);
    return mean(sums.absolute, sums);
}

std::optional<double> mean_squared_error(const MetricInput& input) {
    const DifferenceSums sums = difference_sums(input);
    return mean(sums.squared, sums);
}

}  // namespace aoscore
