#include "metrics/measures/finest_similarity.h"

#include "metrics/measures/shared_sums.h"
#include "metrics/prepared_image.h"

#include <array>
#include <utility>
#include <vector>

namespace aoscore {

BlockGrid similarity_squares(const Mask& valid) {
    return {valid.width, valid.height, valid.width / kSmallestSide_px};
}

FinestSimilarity finest_similarity(const MetricInput& input) {
    if (input.shared != nullptr && input.shared->finest) return *input.shared->finest;
    const ScaledImage truth(input.truth, input.prepared_truth), test(input.test, input.prepared_test);
    const std::array grids{BlockGrid(input.valid.width, input.valid.height), similarity_squares(input.valid)};
    std::vector<SsimSums> sums =
        structural_similarity(truth.windowed(), test.windowed(), PixelWeights(input.valid), grids);
    FinestSimilarity similarity{std::move(sums[0]), std::move(sums[1])};
    if (input.shared != nullptr) input.shared->finest = similarity;
    return similarity;
}

}  // namespace aoscore
