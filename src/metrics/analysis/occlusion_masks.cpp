#include "metrics/analysis/occlusion_masks.h"

#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

OcclusionMasks occlusion_masks(const MetricInput& input, double threshold) {
    require_one_size(input);
    OcclusionMasks masks{Mask(input.truth.width, input.truth.height),
                         Mask(input.truth.width, input.truth.height)};
    std::size_t valid = 0, missing = 0, false_occlusion = 0;
    for (std::size_t i = 0; i < input.truth.size(); ++i) {
        if (input.valid.pixels[i] == 0) continue;
        ++valid;
        const double difference = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        const double noise = input.standard_error != nullptr
                                 ? kMaskStandardErrors * double{input.standard_error->pixels[i]}
                                 : 0.0;
        const double limit = std::max(threshold, noise);
        missing += masks.missing.pixels[i] = difference > limit ? 1 : 0;
        false_occlusion += masks.false_occlusion.pixels[i] = difference < -limit ? 1 : 0;
    }
    const double count = static_cast<double>(std::max<std::size_t>(valid, 1));
    masks.missing_area = static_cast<double>(missing) / count;
    masks.false_area = static_cast<double>(false_occlusion) / count;
    return masks;
}

MaskSummary summarize_mask(const Mask& mask, const MetricInput& input,
                           const std::vector<PixelFacts::Cause>& causes) {
    struct Sums {
        double weight = 0, error = 0;
        std::optional<double> mean() const {
            return weight > 0 ? std::optional(error / weight) : std::nullopt;
        }
    };
    Sums whole;
    std::vector<Sums> by_cause(causes.size());
    double valid = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (input.valid.pixels[i] == 0) continue;
        ++valid;
        if (mask.pixels[i] == 0) continue;
        const double error = std::abs(double{input.test.pixels[i]} - double{input.truth.pixels[i]});
        whole.weight += 1;
        whole.error += error;
        double occlusion = 0;
        for (const PixelFacts::Cause& cause : causes) occlusion += double{cause.occlusion->pixels[i]};
        if (occlusion <= 0) continue;
        for (std::size_t c = 0; c < causes.size(); ++c) {
            const double part = double{causes[c].occlusion->pixels[i]} / occlusion;
            by_cause[c].weight += part;
            by_cause[c].error += part * error;
        }
    }
    const double count = std::max(valid, 1.0);
    MaskSummary summary{whole.weight / count, whole.mean(), {}};
    for (std::size_t c = 0; c < causes.size(); ++c) {
        summary.causes.push_back({causes[c].name, by_cause[c].weight / count, by_cause[c].mean()});
    }
    return summary;
}

}  // namespace aoscore
