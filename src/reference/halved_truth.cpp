#include "reference/halved_truth.h"

#include "core/sampling.h"
#include "reference/estimate/open_cone.h"

#include <cmath>
#include <utility>

namespace aoscore {
namespace {

// Both are multiples of a step far above float32's rounding of their mean.
void average(ImageF& first, const ImageF& second) {
    for (std::size_t i = 0; i < first.size(); ++i) first.pixels[i] = (first.pixels[i] + second.pixels[i]) / 2;
}

// A pixel that is proven open has no noise in either half: what it states is rounding.
void combine_errors(ImageF& first, const ImageF& second) {
    for (std::size_t i = 0; i < first.size(); ++i) {
        const auto a = double{first.pixels[i]}, b = double{second.pixels[i]};
        if (first.pixels[i] != kProvenError || second.pixels[i] != kProvenError)
            first.pixels[i] = static_cast<float>(std::sqrt(a * a + b * b) / 2);
    }
}

void average_cones(Truth& first, const Truth& second) {
    for (std::size_t i = 0; i < first.bent_normal.size(); ++i) {
        glm::vec3& normal = first.bent_normal.pixels[i];
        normal = (normal + second.bent_normal.pixels[i]) / 2.0F;
        if (first.hits.surface.pixels[i] != 0)
            first.cone_angle_rad.pixels[i] = static_cast<float>(cone_angle_rad(glm::dvec3(normal)));
    }
    combine_errors(first.bent_error_rad, second.bent_error_rad);
    combine_errors(first.cone_error_rad, second.cone_error_rad);
}

}  // namespace

TruthSettings settings_of_half(const TruthSettings& settings, std::size_t half) {
    TruthSettings one = settings;
    one.halves = false;
    one.samples = settings.samples / 2;
    one.seed = mix_bits(mix_bits(settings.seed) + 1 + half);
    return one;
}

Truth mean_of_halves(Truth first, Truth second) {
    for (std::size_t q = 0; q < first.queries.size(); ++q) {
        first.halves.push_back({first.visibility[q], second.visibility[q]});
        average(first.visibility[q], second.visibility[q]);
        combine_errors(first.standard_error[q], second.standard_error[q]);
    }
    for (std::size_t c = 0; c < kCauses; ++c)
        average(first.occlusion_by_cause[c], second.occlusion_by_cause[c]);
    average(first.one_layer_bound, second.one_layer_bound);
    average_cones(first, second);
    for (std::size_t i = 0; i < first.sample_counts.size(); ++i)
        first.sample_counts.pixels[i] += second.sample_counts.pixels[i];
    first.samples += second.samples;
    first.rays += second.rays;
    first.rays_now += second.rays_now;
    first.seconds += second.seconds;
    return first;
}

}  // namespace aoscore
