#include "metrics/analysis/repeats.h"

#include "core/error.h"
#include "metrics/intervals/block_grid.h"

#include <algorithm>

namespace aoscore {
namespace {

/// Sums term(i) over the valid pixels of each block.
template <class Term>
std::vector<double> block_sums(const Mask& valid, Term term) {
    const BlockGrid grid(valid.width, valid.height);
    std::vector<double> sums(grid.size(), 0);
    for (int y = 0; y < valid.height; ++y) {
        const std::size_t row = valid.index(0, y);
        grid.for_each_piece(y, 0, valid.width, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) {
                const std::size_t i = row + static_cast<std::size_t>(x);
                if (valid.pixels[i] != 0) sums[block] += term(i);
            }
        });
    }
    return sums;
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

void require_size(const ImageF& image, const Mask& valid) {
    if (image.width != valid.width || image.height != valid.height)
        throw Error(ExitCode::sizes_differ, "pictures of several sizes cannot be held against each other");
}

}  // namespace

std::optional<FoundOcclusion> found_occlusion(const HiddenOcclusion& occlusion, const ImageF& visibility,
                                              const Mask& valid, Findings findings) {
    for (const ImageF* image : {&occlusion.whole, &occlusion.hidden, &visibility})
        require_size(*image, valid);
    const auto whole = [&](std::size_t i) { return double{occlusion.whole.pixels[i]}; };
    const auto hidden = [&](std::size_t i) { return double{occlusion.hidden.pixels[i]}; };
    const auto shown = [&](std::size_t i) { return 1 - double{visibility.pixels[i]}; };
    const auto over_hidden = [&](auto term) {
        return block_sums(valid, [&](std::size_t i) { return occlusion.is_hidden(i) ? term(i) : 0.0; });
    };
    const auto over_visible = [&](auto term) {
        return block_sums(valid, [&](std::size_t i) { return occlusion.is_visible(i) ? term(i) : 0.0; });
    };
    const auto found = [&](std::size_t i, double strength) {
        const double more = std::min(strength * shown(i), 1.0) - (whole(i) - hidden(i));
        return findings == Findings::free ? more : std::clamp(more, 0.0, hidden(i));
    };
    FoundOcclusion sums;
    sums.visible = over_visible(whole);
    sums.kept = over_visible(shown);
    sums.hidden = over_hidden(hidden);
    if (sum_of(sums.hidden) <= 0 || sum_of(sums.kept) <= 0 || sum_of(sums.visible) <= 0) return std::nullopt;
    sums.strength = sum_of(sums.visible) / sum_of(sums.kept);
    sums.found = over_hidden([&](std::size_t i) { return found(i, 1); });
    sums.found_fitted = over_hidden([&](std::size_t i) { return found(i, sums.strength); });
    sums.pixels = over_hidden([](std::size_t) { return 1.0; });
    const auto part = [&](std::size_t i) { return found(i, sums.strength) / hidden(i); };
    sums.parts = over_hidden(part);
    sums.squared_parts = over_hidden([&](std::size_t i) { return part(i) * part(i); });
    sums.finders = over_hidden([&](std::size_t i) {
        return found(i, sums.strength) >= FoundOcclusion::kFinds * hidden(i) ? 1.0 : 0.0;
    });
    return sums;
}

namespace {

/// The mean over each square of a picture's differences from `converged`, at each of its valid pixels.
ImageF square_means(const ImageF& picture, const ImageF& converged, const Mask& valid) {
    constexpr int kSide = Convergence::kSide;
    const int across = (valid.width + kSide - 1) / kSide, down = (valid.height + kSide - 1) / kSide;
    std::vector<double> sums(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), 0);
    std::vector<double> counts(sums.size(), 0);
    const auto square = [&](int x, int y) {
        return static_cast<std::size_t>(y / kSide) * static_cast<std::size_t>(across) +
               static_cast<std::size_t>(x / kSide);
    };
    ImageF means(valid.width, valid.height, 0);
    for (int y = 0; y < valid.height; ++y) {
        for (int x = 0; x < valid.width; ++x) {
            if (valid.at(x, y) == 0) continue;
            sums[square(x, y)] += double{picture.at(x, y)} - double{converged.at(x, y)};
            counts[square(x, y)] += 1;
        }
    }
    for (int y = 0; y < valid.height; ++y) {
        for (int x = 0; x < valid.width; ++x) {
            if (valid.at(x, y) != 0)
                means.at(x, y) = static_cast<float>(sums[square(x, y)] / counts[square(x, y)]);
        }
    }
    return means;
}

}  // namespace

Convergence convergence(const std::vector<ImageF>& pictures, const ImageF& converged, const Mask& valid) {
    require_size(converged, valid);
    Convergence sums;
    for (const ImageF& picture : pictures) {
        require_size(picture, valid);
        const ImageF means = square_means(picture, converged, valid);
        add_sums(sums.counts, valid_counts(valid));
        add_sums(sums.squares, block_sums(valid, [&](std::size_t i) {
                     const double off = double{picture.pixels[i]} - double{converged.pixels[i]};
                     return off * off;
                 }));
        add_sums(sums.bands, block_sums(valid, [&](std::size_t i) {
                     return double{means.pixels[i]} * double{means.pixels[i]};
                 }));
    }
    return sums;
}

std::vector<double> variance_sums(const std::vector<ImageF>& of, const Mask& valid) {
    if (of.size() < 2) throw internal_error("one picture has no variance");
    for (const ImageF& image : of) require_size(image, valid);
    const double n = static_cast<double>(of.size());
    return block_sums(valid, [&](std::size_t i) {
        double mean = 0, variance = 0;
        for (const ImageF& image : of) mean += double{image.pixels[i]} / n;
        for (const ImageF& image : of) {
            const double off = double{image.pixels[i]} - mean;
            variance += off * off / (n - 1);
        }
        return variance;
    });
}

std::vector<double> valid_counts(const Mask& valid) {
    return block_sums(valid, [](std::size_t) { return 1.0; });
}

ImageF mean_image(const std::vector<ImageF>& of) {
    ImageF mean(of.at(0).width, of.at(0).height);
    for (std::size_t i = 0; i < mean.size(); ++i) {
        double sum = 0;
        for (const ImageF& image : of) sum += double{image.pixels[i]};
        mean.pixels[i] = static_cast<float>(sum / static_cast<double>(of.size()));
    }
    return mean;
}

}  // namespace aoscore
