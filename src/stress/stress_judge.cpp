#include "stress/stress_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aoscore {

double stress_limit(StressJudgement judgement) {
    return judgement == StressJudgement::same_picture ? kSamePictureLimit : kErrorLimit;
}

void count_faults(const StressedPicture& picture, StressCell& cell) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.visibility.size(); ++i) {
        const float v = picture.visibility.pixels[i];
        if (!std::isfinite(v)) {
            ++cell.nonfinite;
            continue;
        }
        cell.out_of_range += v < 0 || v > 1;
        if (picture.surface.pixels[i] == 0) {
            cell.background += v != 1;
        } else {
            sum += static_cast<double>(v);
            ++count;
        }
    }
    if (count > 0) cell.mean = sum / static_cast<double>(count);
}

std::optional<double> same_picture_deviation(const StressedPicture& picture, const ImageF& base,
                                             const Mask& base_valid, ImageF& difference) {
    difference = ImageF(base.width, base.height, 0);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const float d = picture.visibility.pixels[i] - base.pixels[i];
        if (picture.valid.pixels[i] == 0 || base_valid.pixels[i] == 0 || !std::isfinite(d)) continue;
        difference.pixels[i] = d;
        sum += static_cast<double>(d) * static_cast<double>(d);
        ++count;
    }
    if (count < kLeastComparedPixels) return std::nullopt;
    return std::sqrt(sum / static_cast<double>(count));
}

std::optional<double> debiased_error(const StressedPicture& picture, ImageF& difference) {
    difference = ImageF(picture.visibility.width, picture.visibility.height, 0);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.visibility.size(); ++i) {
        const float d = picture.visibility.pixels[i] - picture.truth->pixels[i];
        if (picture.valid.pixels[i] == 0 || !std::isfinite(d)) continue;
        difference.pixels[i] = d;
        const auto noise = static_cast<double>(picture.standard_error->pixels[i]);
        sum += static_cast<double>(d) * static_cast<double>(d) - noise * noise;
        ++count;
    }
    if (count < kLeastComparedPixels) return std::nullopt;
    return std::sqrt(std::max(sum / static_cast<double>(count), 0.0));
}

void compare_with_unstressed(StressJudgement judgement, const StressedPicture& picture,
                             const UnstressedPicture& unstressed, StressCell& cell, ImageF& difference) {
    if (picture.truth == nullptr) {
        if (cell.mean && unstressed.mean) cell.deviation = std::abs(*cell.mean - *unstressed.mean);
    } else if (judgement == StressJudgement::same_picture) {
        cell.deviation = same_picture_deviation(picture, unstressed.visibility, unstressed.valid, difference);
    } else {
        cell.rmse = debiased_error(picture, difference);
        if (cell.rmse && unstressed.rmse) cell.deviation = *cell.rmse - *unstressed.rmse;
    }
}

void judge(StressJudgement judgement, StressCell& cell) {
    if (!cell.skipped.empty()) return;
    if (!cell.error.empty()) {
        cell.breaks = "does not run";
    } else if (cell.nonfinite > 0) {
        cell.breaks = fmt::format("{} pixels are NaN or infinite", cell.nonfinite);
    } else if (cell.out_of_range > 0) {
        cell.breaks = fmt::format("{} pixels lie outside of [0,1]", cell.out_of_range);
    } else if (cell.background > 0) {
        cell.breaks = fmt::format("{} pixels without surface are shaded", cell.background);
    } else if (cell.deviation && *cell.deviation > stress_limit(judgement)) {
        cell.breaks =
            fmt::format("deviates by {:.3f}, more than {:g}", *cell.deviation, stress_limit(judgement));
    }
}

}  // namespace aoscore
