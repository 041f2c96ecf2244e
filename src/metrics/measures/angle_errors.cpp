#include "metrics/measures/angle_errors.h"

#include "metrics/intervals/block_grid.h"
#include "metrics/measures/mean_error.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

bool counts(const SignalInput& input, std::size_t i) {
    return input.valid.pixels[i] != 0 && input.standard_error.pixels[i] <= kKnownWithin_rad;
}

/// The errors of all pixels that count.
template <class ErrorAt>
std::vector<double> errors_of(const SignalInput& input, const ErrorAt& error_at) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < input.valid.size(); ++i) {
        if (counts(input, i)) errors.push_back(error_at(i));
    }
    return errors;
}

glm::dvec3 vector_at(const SignalImage& image, std::size_t i) {
    return {image[0].pixels[i], image[1].pixels[i], image[2].pixels[i]};
}

std::string unknown_note(const std::vector<double>& errors, const SignalInput& input) {
    const auto valid = std::ranges::count_if(input.valid.pixels, [](std::uint8_t v) { return v != 0; });
    const auto unknown = static_cast<std::size_t>(valid) - errors.size();
    if (unknown == 0) return "";
    return fmt::format("without {} of {} pixels, where the truth's standard error exceeds 10 degrees",
                       unknown, valid);
}

constexpr const char* kNoKnownPixel = "the truth's standard error exceeds 10 degrees at every valid pixel";

}  // namespace

std::vector<double> direction_errors_deg(const SignalInput& input) {
    return errors_of(input, [&](std::size_t i) {
        const glm::dvec3 a = vector_at(input.truth, i), b = vector_at(input.test, i);
        return kDegrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    });
}

std::vector<double> angle_differences_deg(const SignalInput& input) {
    return errors_of(input, [&](std::size_t i) {
        return kDegrees *
               (static_cast<double>(input.test[0].pixels[i]) - static_cast<double>(input.truth[0].pixels[i]));
    });
}

AngleBlocks blocks_of(const std::vector<double>& errors_deg, const SignalInput& input) {
    if (!std::ranges::all_of(errors_deg, [](double error) { return std::isfinite(error); })) return {};
    const BlockGrid grid(input.valid.width, input.valid.height);
    const std::vector<double> none(grid.size(), 0.0);
    AngleBlocks blocks{none, none, none};
    std::size_t at = 0;
    for (std::size_t i = 0; i < input.valid.size(); ++i) {
        if (!counts(input, i)) continue;
        const std::size_t width = static_cast<std::size_t>(input.valid.width);
        const std::size_t side = static_cast<std::size_t>(grid.side_px);
        const std::size_t block = i / width / side * static_cast<std::size_t>(grid.across) + i % width / side;
        blocks.counts[block] += 1;
        blocks.absolute_sums[block] += std::abs(errors_deg[at]);
        blocks.signed_sums[block] += errors_deg[at];
        ++at;
    }
    return blocks;
}

ImageF image_of(const std::vector<double>& errors_deg, const SignalInput& input) {
    ImageF image(input.valid.width, input.valid.height, std::numeric_limits<float>::quiet_NaN());
    std::size_t at = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (counts(input, i)) image.pixels[i] = static_cast<float>(errors_deg[at++]);
    }
    return image;
}

MetricValue mean_size(const std::vector<double>& errors, const SignalInput& input) {
    if (errors.empty()) return undefined(kNoKnownPixel);
    double sum = 0;
    for (const double error : errors) sum += std::abs(error);
    return {sum / static_cast<double>(errors.size()), unknown_note(errors, input)};
}

MetricValue size_at_95_percent(std::vector<double> errors, const SignalInput& input) {
    if (errors.empty()) return undefined(kNoKnownPixel);
    std::string note = unknown_note(errors, input);
    for (double& error : errors) error = std::abs(error);
    const std::size_t rank = (errors.size() * 95 + 99) / 100;  // counted from 1
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::ranges::nth_element(errors, place);
    return {*place, std::move(note)};
}

}  // namespace aoscore
