#include "metrics/measures/mean_error.h"

#include "core/error.h"
#include "core/threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace aoscore {

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

std::optional<double> PixelSum::mean() const {
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

PixelSum sum_of_rows(int height, const std::function<PixelSum(int)>& row) {
    std::vector<PixelSum> rows(static_cast<std::size_t>(height));
    parallel_for(rows.size(), [&](std::size_t y) { rows[y] = row(static_cast<int>(y)); });
    PixelSum all;
    for (const PixelSum& each : rows) {
        all.sum += each.sum;
        all.count += each.count;
    }
    return all;
}

std::optional<double> mean_squared_error(const MetricInput& input) {
    return mean_over_valid(input, [](double difference) { return difference * difference; });
}

}  // namespace aoscore
