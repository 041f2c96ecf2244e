#include "jobs/truth_side.h"

#include <cstddef>

namespace aoscore {
namespace {

// Enough for a truth and its halves at 2560x1440.
constexpr double kMostKept_bytes = 640.0 * (1 << 20);

}  // namespace

TruthSide::TruthSide(const Truth& truth, const Ground& ground)
    : divisions_(pixel_divisions(ground.contract.valid, ground.facts)) {
    const Mask& valid = ground.contract.valid;
    const std::size_t images = truth.halves.empty() ? 1 : 1 + truth.halves[0].size();
    if (PreparedImage::kBytesPerPixel * static_cast<double>(images * valid.size()) > kMostKept_bytes) return;
    images_.reserve(images);
    images_.emplace_back(truth.visibility[0], valid);
    if (truth.halves.empty()) return;
    for (const ImageF& half : truth.halves[0]) images_.emplace_back(half, valid);
}

}  // namespace aoscore
