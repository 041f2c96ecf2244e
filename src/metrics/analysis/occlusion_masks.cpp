#include "metrics/analysis/occlusion_masks.h"

#include "core/threads.h"
#include "metrics/measures/bands.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace aoscore {

namespace {

struct MaskCounts {
    std::size_t valid = 0, missing = 0, false_occlusion = 0;
};

/// The error that a mask needs at each pixel of a row.
AOSCORE_WIDER_WHERE_POSSIBLE
void find_limits(const float* standard_error, double threshold, double* limits, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        limits[i] = std::max(threshold, kMaskStandardErrors * double{standard_error[i]});
}

AOSCORE_WIDER_WHERE_POSSIBLE
void mark(const float* truth, const float* test, const std::uint8_t* valid, const double* limits,
          std::uint8_t* missing, std::uint8_t* false_occlusion, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double difference = double{test[i]} - double{truth[i]};
        const bool brighter = difference > limits[i], darker = difference < -limits[i];
        missing[i] = static_cast<std::uint8_t>(brighter & (valid[i] != 0));
        false_occlusion[i] = static_cast<std::uint8_t>(darker & (valid[i] != 0));
    }
}

std::size_t marked(const std::uint8_t* marks, std::size_t count) {
    return count - static_cast<std::size_t>(std::count(marks, marks + count, std::uint8_t{0}));
}

MaskCounts mark_row(const MetricInput& input, double threshold, int y, OcclusionMasks& masks) {
    const auto width = static_cast<std::size_t>(input.valid.width);
    std::vector<double> limits(width, threshold);
    if (input.standard_error != nullptr)
        find_limits(&input.standard_error->at(0, y), threshold, limits.data(), width);
    std::uint8_t *missing = &masks.missing.at(0, y), *false_occlusion = &masks.false_occlusion.at(0, y);
    mark(&input.truth.at(0, y), &input.test.at(0, y), &input.valid.at(0, y), limits.data(), missing,
         false_occlusion, width);
    return {marked(&input.valid.at(0, y), width), marked(missing, width), marked(false_occlusion, width)};
}

/// Sums of weighted errors.
struct ErrorSums {
    double weight = 0, error = 0;
    void add(double w, double e) {
        weight += w;
        error += w * e;
    }
    void add(const ErrorSums& other) {
        weight += other.weight;
        error += other.error;
    }
    std::optional<double> mean() const { return weight > 0 ? std::optional(error / weight) : std::nullopt; }
};

/// The sums over a mask, and over the part of each cause.
struct MaskSums {
    double valid = 0;
    ErrorSums whole;
    std::vector<ErrorSums> by_cause;

    void add(const MaskSums& other) {
        valid += other.valid;
        whole.add(other.whole);
        for (std::size_t c = 0; c < by_cause.size(); ++c) by_cause[c].add(other.by_cause[c]);
    }
};

void add_pixel(const MetricInput& input, const std::vector<PixelFacts::Cause>& causes, std::size_t i,
               MaskSums& sums) {
    const double error = std::abs(double{input.test.pixels[i]} - double{input.truth.pixels[i]});
    sums.whole.add(1, error);
    double occlusion = 0;
    for (const PixelFacts::Cause& cause : causes) occlusion += double{cause.occlusion->pixels[i]};
    if (occlusion <= 0) return;
    for (std::size_t c = 0; c < causes.size(); ++c)
        sums.by_cause[c].add(double{causes[c].occlusion->pixels[i]} / occlusion, error);
}

MaskSums sums_of_mask(const Mask& mask, const MetricInput& input,
                      const std::vector<PixelFacts::Cause>& causes) {
    std::vector<MaskSums> bands(band_count(mask.height));
    for_each_band(mask.height, [&](std::size_t band, int first_row, int rows) {
        MaskSums sums;
        sums.by_cause.resize(causes.size());
        const auto width = static_cast<std::size_t>(mask.width);
        const std::size_t first = static_cast<std::size_t>(first_row) * width;
        for (std::size_t i = first; i < first + static_cast<std::size_t>(rows) * width; ++i) {
            if (input.valid.pixels[i] == 0) continue;
            ++sums.valid;
            if (mask.pixels[i] != 0) add_pixel(input, causes, i, sums);
        }
        bands[band] = std::move(sums);
    });
    MaskSums all;
    all.by_cause.resize(causes.size());
    for (const MaskSums& band : bands) all.add(band);
    return all;
}

}  // namespace

OcclusionMasks occlusion_masks(const MetricInput& input, double threshold) {
    require_one_size(input);
    OcclusionMasks masks{Mask(input.truth.width, input.truth.height),
                         Mask(input.truth.width, input.truth.height)};
    std::vector<MaskCounts> rows(static_cast<std::size_t>(input.truth.height));
    parallel_for(rows.size(),
                 [&](std::size_t y) { rows[y] = mark_row(input, threshold, static_cast<int>(y), masks); });
    MaskCounts all;
    for (const MaskCounts& row : rows) {
        all.valid += row.valid;
        all.missing += row.missing;
        all.false_occlusion += row.false_occlusion;
    }
    const double count = static_cast<double>(std::max<std::size_t>(all.valid, 1));
    masks.missing_area = static_cast<double>(all.missing) / count;
    masks.false_area = static_cast<double>(all.false_occlusion) / count;
    return masks;
}

MaskSummary summarize_mask(const Mask& mask, const MetricInput& input,
                           const std::vector<PixelFacts::Cause>& causes) {
    const MaskSums sums = sums_of_mask(mask, input, causes);
    const double count = std::max(sums.valid, 1.0);
    MaskSummary summary{sums.whole.weight / count, sums.whole.mean(), {}};
    for (std::size_t c = 0; c < causes.size(); ++c) {
        const ErrorSums& of_cause = sums.by_cause[c];
        summary.causes.push_back({causes[c].name, of_cause.weight / count, of_cause.mean()});
    }
    return summary;
}

}  // namespace aoscore
