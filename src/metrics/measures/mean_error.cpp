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

std::optional<double> mean_over_valid(const MetricInput& input, const std::function<double(double)>& term) {
    require_one_size(input);
    struct Row {
        double sum = 0;
        std::size_t count = 0;
    };
    std::vector<Row> rows(static_cast<std::size_t>(input.truth.height));
    parallel_for(rows.size(), [&](std::size_t y) {
        for (int x = 0; x < input.truth.width; ++x) {
            const std::size_t i = input.truth.index(x, static_cast<int>(y));
            if (input.valid.pixels[i] == 0) continue;
            rows[y].sum += term(double{input.test.pixels[i]} - double{input.truth.pixels[i]});
            ++rows[y].count;
        }
    });
    Row all;
    for (const Row& row : rows) {
        all.sum += row.sum;
        all.count += row.count;
    }
    if (all.count == 0) return std::nullopt;
    return all.sum / static_cast<double>(all.count);
}

std::optional<double> mean_squared_error(const MetricInput& input) {
    return mean_over_valid(input, [](double difference) { return difference * difference; });
}

}  // namespace aoscore
