#pragma once

#include "metrics/evaluate.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/intervals/truth_noise.h"

#include <array>
#include <map>
#include <span>
#include <string>

namespace aoscore::testing {

/// Metrics against a truth of two halves, without the truth's noise.
struct HalvedScores {
    std::map<std::string, MetricValue> values;
    std::map<std::string, double> noise;
};

/// Scores an image by the metrics of these ids, or by all; `truth` is the mean of the halves, and all images
/// have one size. `samples` rays a pixel are those of both halves.
inline HalvedScores halved_scores(const ImageF& truth, const ImageF& first, const ImageF& second,
                                  const ImageF& test, const Mask& valid, int samples,
                                  std::span<const std::string> ids = {}) {
    std::array<MapSums, 4> maps;
    const TruthHalves halves{first, second, &maps[1], &maps[2], nullptr, &maps[3], samples};
    MetricInput input{truth, test, valid};
    input.maps = &maps[0];
    input.halves = &halves;
    HalvedScores scores;
    scores.values = evaluate(input, ids);
    scores.noise = truth_noise(block_errors(input), block_errors(against_half(input, 0)),
                               block_errors(against_half(input, 1)), halves);
    return scores;
}

}  // namespace aoscore::testing
