#include "jobs/truth_side.h"

namespace aoscore {
namespace {

// Enough for a truth and its halves at 2560x1440.
constexpr double kMostKept_bytes = 800.0 * (1 << 20);

}  // namespace

TruthSide::TruthSide(const Truth& truth, const Ground& ground)
    : divisions_(pixel_divisions(ground.contract.valid, ground.facts)) {
    const Mask& valid = ground.contract.valid;
    const bool halved = !truth.halves.empty();
    const double bytes_per_pixel = halved ? PreparedHalves::kBytesPerPixel : PreparedImage::kBytesPerPixel;
    if (bytes_per_pixel * static_cast<double>(valid.size()) > kMostKept_bytes) return;
    if (halved)
        halves_.emplace(truth.visibility[0], truth.halves[0][0], truth.halves[0][1], valid);
    else
        undivided_.emplace(truth.visibility[0], valid);
}

}  // namespace aoscore
