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

void extrapolate(MapSums& whole, const MapSums& first, const MapSums& second) {
    extrapolate(whole.ssim_sums, first.ssim_sums, second.ssim_sums);
    extrapolate(whole.flip_sums, first.flip_sums, second.flip_sums);
    if (!whole.ms_ssim || !first.ms_ssim || !second.ms_ssim) {
        whole.ms_ssim.reset();
        whole.ms_ssim_influences.clear();
        return;
    }
    whole.ms_ssim = extrapolated(*whole.ms_ssim, *first.ms_ssim, *second.ms_ssim);
    extrapolate(whole.ms_ssim_influences, first.ms_ssim_influences, second.ms_ssim_influences);
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

MetricValue extrapolated(const MetricValue& whole, const MetricValue& first, const MetricValue& second) {
    if (!whole.value || !first.value || !second.value) return whole;
    return {extrapolated(*whole.value, *first.value, *second.value), whole.note};
}

BlockErrors extrapolated(BlockErrors whole, const BlockErrors& first, const BlockErrors& second) {
    extrapolate(whole.absolute_sums, first.absolute_sums, second.absolute_sums);
    extrapolate(whole.maps, first.maps, second.maps);
    return whole;
}

}  // namespace aoscore
