#pragma once

#include "core/image.h"

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

class PreparedHalves;
class PreparedImage;
struct DrawnSums;
struct MapSums;
struct SharedSums;

/// The two independent halves whose mean a truth is. The difference of a value between them shows the effect
/// of the truth's noise.
struct TruthHalves {
    const ImageF& first;
    const ImageF& second;
    MapSums* first_maps = nullptr;  ///< like MetricInput::maps, for the metrics against each half
    MapSums* second_maps = nullptr;
    const PreparedHalves* prepared = nullptr;  ///< of the truth and of these, where shared
    /// Like MetricInput::maps, against the truth with all of its noise, for the metrics that state their
    /// error by what it did to them (Metric::left_by_noise).
    MapSums* noisy_maps = nullptr;
    int samples = 0;  ///< rays a pixel of both together; 0 where they are not known
};

/// The input of a metric. All images have one size and hold visibility in [0,1], 1 = open.
struct MetricInput {
    const ImageF& truth;
    const ImageF& test;
    const Mask& valid;                       ///< pixels that count; finite in both images
    const ImageF* standard_error = nullptr;  ///< the truth's, where it is known
    MapSums* maps = nullptr;  ///< receives the sums of metrics that are means of a map, if not null
    const TruthHalves* halves = nullptr;  ///< the truth's, where it has two
    /// Of `truth` and `valid`, where shared; evaluate() has PreparedHalves for a truth of two halves.
    const PreparedImage* prepared_truth = nullptr;
    const PreparedImage* prepared_test = nullptr;  ///< made of `test` and `valid`
    /// Receives what several metrics of this very pair have in common, if not null, so that only the first of
    /// them needs to measure it. The halves have their own.
    SharedSums* shared = nullptr;
};

struct MetricValue {
    std::optional<double> value;  ///< empty where undefined; never NaN
    std::string note;             ///< why it is undefined, or the pixel where it was found
};

/// One metric: a row of the table in metrics.cpp and a file of its own.
struct Metric {
    enum class Better { lower, higher, nearer_zero };
    std::string_view id;         ///< its name on the command line and in JSON
    std::string_view label;      ///< the label of a column
    std::string_view in_text;    ///< the label within a sentence
    std::string_view unit = {};  ///< "" for visibility itself
    Better better;
    int decimals = 4;             ///< decimals for printing
    std::string_view meaning;     ///< one sentence for the page
    std::string_view paper = {};  ///< author, title, year; "" for elementary ones
    MetricValue (*measure)(const MetricInput&);
    double (*over_views)(std::span<const double>);  ///< averages one value a view; see over_views.h
    /// Computes the metric from resampled blocks, for its interval. Null where blocks cannot give it.
    double (*resampled)(const DrawnSums&) = nullptr;
    /// The treatment of the truth's noise, where the truth has two halves. Its variance is `taken_off` a mean
    /// square. An `extrapolated` metric changes in proportion to the noise's variance, so that its value for
    /// a truth without noise is extrapolated; see extrapolation.h.
    enum class Noise { included, taken_off, extrapolated };
    Noise noise = Noise::included;
    /// The error that the extrapolation leaves as a part of its correction, root mean square over scenes: a
    /// constant, and one for each unit of the noise's standard deviation, as the correction is of the second
    /// order in the noise and what it leaves of the third. Both were measured, see truth_noise().
    double left_always = 0, left_by_deviation = 0;
    /// The same as a part of all that the noise did to the value, from the one against the truth as it is to
    /// the extrapolated one, for one ray a pixel: for metrics whose prepared truth has most of the noise
    /// taken off before, so that the correction is what is left of it, and may be 0 by chance. Measured, too.
    double left_by_noise = 0;
    /// The part of the correction that noise of this mean variance leaves.
    double part_left(double noise_variance) const {
        return left_always + left_by_deviation * std::sqrt(noise_variance);
    }
    /// The part of all that the noise did which stays at so many rays a pixel. It falls as a standard error
    /// of theirs does. The noise's variance over the picture tells it less well: pictures of one number of
    /// rays differ in it more than in what stays.
    double part_of_noise_left(int samples) const { return left_by_noise * std::pow(samples, -0.75); }
    /// The mean variance of the noise beyond which the metric is not worth its time, see told_metrics().
    double most_noise_variance = std::numeric_limits<double>::infinity();
    bool brief = false;     ///< also in tables for readers, whose width is limited
    bool unranked = false;  ///< also measured before the filter and against a method's own truth
    /// The id of the same metric without the truth's noise, which this one includes; "" where it includes
    /// none.
    std::string_view without_noise = {};
};

/// The one table of metrics, in the order of columns.
const std::vector<Metric>& metrics();

/// The pixels of `candidate` where both images are finite. `nonfinite` receives the number of the others.
Mask finite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate, std::size_t& nonfinite);
/// Only the number of the others. Both throw sizes_differ.
std::size_t nonfinite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate);

}  // namespace aoscore
