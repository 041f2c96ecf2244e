#pragma once

#include "core/image.h"
#include "metrics/metric.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Occlusion that ought to be there, and the part of it that one depth layer hides from a method, both in
/// [0,1] and of one size.
struct HiddenOcclusion {
    ImageF whole, hidden;

    static constexpr float kLeast = 0.02F;     ///< a pixel with more hidden occlusion counts as one
    static constexpr float kHardly = 0.0001F;  ///< with less, nothing is hidden from it
    bool is_hidden(std::size_t i) const { return hidden.pixels[i] > kLeast; }
    bool is_visible(std::size_t i) const { return hidden.pixels[i] < kHardly; }
};

/// What a picture finds of hidden occlusion, and what it keeps of the rest, summed over the blocks of
/// BlockGrid, which are resampled for intervals.
struct FoundOcclusion {
    /// Multiplies the picture's occlusion so that its sum is right over the pixels from which nothing is
    /// hidden.
    double strength = 1;
    std::vector<double> hidden;        ///< hidden occlusion, over the pixels that have some
    std::vector<double> found;         ///< what the picture finds of it
    std::vector<double> found_fitted;  ///< the same at that strength, cut off at full occlusion
    std::vector<double> visible;       ///< occlusion over the pixels from which nothing is hidden
    std::vector<double> kept;          ///< the picture's occlusion there
    std::vector<double> pixels;        ///< pixels with hidden occlusion
    std::vector<double> finders;  ///< those of them where a fifth of it or more is found at that strength
    /// The part of it that is found at that strength, and its square, summed over those pixels.
    std::vector<double> parts, squared_parts;

    static constexpr double kFinds = 0.2;
};

/// Whether what a picture finds is held between nothing and all, pixel by pixel: against a truth, whose
/// remaining occlusion the method may miss for other reasons. Without it the sums are free of bias by noise.
enum class Findings { free, within_hidden };

/// Sums over the `valid` pixels what a picture of visibility finds. Empty where no pixel has hidden
/// occlusion, or the picture has no occlusion where nothing is hidden. Throws sizes_differ.
std::optional<FoundOcclusion> found_occlusion(const HiddenOcclusion& occlusion, const ImageF& visibility,
                                              const Mask& valid, Findings findings);

/// How far pictures are from what their estimator converges to, summed over the blocks of BlockGrid.
struct Convergence {
    std::vector<double> counts;   ///< valid pixels, of all pictures together
    std::vector<double> squares;  ///< squared differences
    /// The part of them that is alike over squares of kSide pixels: the square of a square's mean for each of
    /// its pixels. A filter of that size leaves it: it is seen as bands, the rest as noise.
    std::vector<double> bands;

    static constexpr int kSide = 4;
};

/// Sums the differences of `pictures` from `converged`, all of one size. Throws sizes_differ.
Convergence convergence(const std::vector<ImageF>& pictures, const ImageF& converged, const Mask& valid);

/// Errors of a signal's angles, degrees, summed over the blocks of BlockGrid, of the pixels that its metrics
/// count.
struct AngleBlocks {
    std::vector<double> counts, absolute_sums;
    std::vector<double> signed_sums;  ///< of test - truth; of directions, which have no sign, of the angle
};

/// What drawing a cell again shows: with other seeds, and over one depth layer and over all.
struct Repeats {
    static constexpr int kSeeds = 4;
    std::vector<double> counts;        ///< valid pixels of each block of BlockGrid
    std::vector<double> variance;      ///< variance of a pixel over the seeds, summed over each block
    std::vector<double> raw_variance;  ///< the same before the filter
    /// What is found of the truth's hidden occlusion (its cause "hidden"), by the filtered picture; and of
    /// what the same estimator finds over all layers and not over the first, by the unfiltered one. Both are
    /// means over the seeds. Of grazing: what is found of the truth's occlusion by surfaces that the camera
    /// sees at a grazing angle (its cause "grazing"), as of the hidden one.
    std::optional<FoundOcclusion> of_truth, of_layers, of_grazing;
    /// How far from the converged picture, before and after the filter, where that was asked for; it is
    /// filtered likewise.
    std::optional<Convergence> raw_from_converged, from_converged;
    /// Metrics of signals beside visibility where the truth has hidden occlusion, and where it has none.
    std::map<std::string, std::map<std::string, MetricValue>> hidden_signals, other_signals;
    std::map<std::string, AngleBlocks> hidden_angles, other_angles;
};

/// Sums of a pixel's variance over pictures of several seeds, for each block: `of` of one size, two at least.
std::vector<double> variance_sums(const std::vector<ImageF>& of, const Mask& valid);
/// The number of valid pixels of each block.
std::vector<double> valid_counts(const Mask& valid);
/// The mean of pictures of one size.
ImageF mean_image(const std::vector<ImageF>& of);

}  // namespace aoscore
