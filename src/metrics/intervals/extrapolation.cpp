#include "metrics/intervals/extrapolation.h"

#include "metrics/prepared_halves.h"

#include <cstddef>
#include <vector>

namespace aoscore {
namespace {

void extrapolate(std::vector<double>& whole, const std::vector<double>& first,
                 const std::vector<double>& second) {
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = extrapolated(whole[i], first[i], second[i]);
}

}  // namespace

MetricInput against_half(const MetricInput& input, std::size_t half) {
    const TruthHalves& halves = *input.halves;
    MetricInput against{half == 0 ? halves.first : halves.second, input.test, input.valid};
    against.maps = half == 0 ? halves.first_maps : halves.second_maps;
    if (halves.prepared != nullptr)
        against.prepared_truth = half == 0 ? &halves.prepared->first : &halves.prepared->second;
    against.prepared_test = input.prepared_test;
    return against;
}

MapSums noisier_maps(const MetricInput& input) {
    const MapSums* const maps = input.halves->noisier_maps;
    return maps != nullptr ? *maps : MapSums{};
}

MetricInput against_noisier(const MetricInput& input) {
    MetricInput against{input.truth, input.test, input.valid};
    against.maps = input.halves->noisier_maps;
    against.prepared_truth = &input.halves->prepared->noisier;
    against.prepared_test = input.prepared_test;
    return against;
}

MetricValue extrapolated(const MetricValue& whole, const MetricValue& first, const MetricValue& second) {
    if (!whole.value || !first.value || !second.value) return whole;
    return {extrapolated(*whole.value, *first.value, *second.value), whole.note};
}

BlockErrors extrapolated(BlockErrors whole, const BlockErrors& first, const BlockErrors& second) {
    extrapolate(whole.absolute_sums, first.absolute_sums, second.absolute_sums);
    extrapolate(whole.maps.flip_sums, first.maps.flip_sums, second.maps.flip_sums);
    return whole;
}

}  // namespace aoscore
