#include "metrics/intervals/extrapolation.h"

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
    against.prepared_truth = half == 0 ? halves.first_prepared : halves.second_prepared;
    against.prepared_test = input.prepared_test;
    return against;
}

MetricValue extrapolated(const MetricValue& whole, const MetricValue& first, const MetricValue& second) {
    if (!whole.value || !first.value || !second.value) return whole;
    return {extrapolated(*whole.value, *first.value, *second.value), whole.note};
}

BlockErrors extrapolated(BlockErrors whole, const BlockErrors& first, const BlockErrors& second) {
    extrapolate(whole.absolute_sums, first.absolute_sums, second.absolute_sums);
    MapSums& maps = whole.maps;
    extrapolate(maps.ssim_sums, first.maps.ssim_sums, second.maps.ssim_sums);
    extrapolate(maps.flip_sums, first.maps.flip_sums, second.maps.flip_sums);
    if (!maps.ms_ssim || !first.maps.ms_ssim || !second.maps.ms_ssim) return whole;
    maps.ms_ssim = extrapolated(*maps.ms_ssim, *first.maps.ms_ssim, *second.maps.ms_ssim);
    extrapolate(maps.ms_ssim_influences, first.maps.ms_ssim_influences, second.maps.ms_ssim_influences);
    return whole;
}

}  // namespace aoscore
