#include "page/live/live_preview.h"

namespace aoscore {

namespace {

constexpr int kPreviewWidth_px = 320;
constexpr int kLeastFactor = 3;

}  // namespace

int preview_factor(int width) {
    return std::max(kLeastFactor, (width + kPreviewWidth_px - 1) / kPreviewWidth_px);
}

}  // namespace aoscore
