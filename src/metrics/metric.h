#pragma once

#include "core/image.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

class PreparedImage;
struct DrawnSums;
struct MapSums;

/// The two independent halves whose mean a truth is. How far a value lies apart between them says what the
/// truth's noise does to it.
struct TruthHalves {
    const ImageF& first;
    const ImageF& second;
    MapSums* first_maps = nullptr;  ///< as MetricInput::maps, of the same metrics against each half
    MapSums* second_maps = nullptr;
    const PreparedImage* first_prepared = nullptr;  ///< as MetricInput::prepared_truth
    const PreparedImage* second_prepared = nullptr;
};

/// What a metric looks at. All images have one size; visibility in [0,1], 1 = open.
struct MetricInput {
    const ImageF& truth;
    const ImageF& test;
    const Mask& valid;                       ///< pixels that count; finite in both images
    const ImageF* standard_error = nullptr;  ///< of the truth, where it is known
    MapSums* maps = nullptr;  ///< where metrics that are means of a map leave what they add up, if wanted
    const TruthHalves* halves = nullptr;            ///< of the truth, where it has two
    const PreparedImage* prepared_truth = nullptr;  ///< of `truth` and `valid`, where others need it as well
    const PreparedImage* prepared_test = nullptr;   ///< of `test` and `valid`
};

struct MetricValue {
    std::optional<double> value;  ///< empty where undefined; never NaN
    std::string note;             ///< why it is undefined, or at which pixel it was found
};

/// One metric: a row of the table in metrics.cpp and a file of its own.
struct Metric {
    enum class Better { lower, higher, nearer_zero };
    std::string_view id;         ///< command line, JSON key
    std::string_view label;      ///< a column's
    std::string_view in_text;    ///< the label within a sentence
    std::string_view unit = {};  ///< "" for visibility itself
    Better better;
    int decimals = 4;             ///< to print it with
    std::string_view meaning;     ///< one sentence for the page
    std::string_view paper = {};  ///< author, title, year; "" for elementary ones
    MetricValue (*measure)(const MetricInput&);
    double (*over_views)(std::span<const double>);  ///< of one value a view; see over_views.h
    /// Of an image whose blocks were drawn again: what its interval is made of. Null where parts of an image
    /// cannot give it.
    double (*resampled)(const DrawnSums&) = nullptr;
    /// What the truth's noise does to it. `extrapolated`: it moves in proportion to the noise's variance, so
    /// that its value for a truth without noise is extrapolated where the truth has two halves; see
    /// extrapolation.h.
    enum class Noise { included, taken_off, extrapolated };
    Noise noise = Noise::included;
    /// What the extrapolation leaves, as a part of what it took off: always, and for each unit of the noise's
    /// mean variance. Measured, see truth_noise().
    double left_always = 0, left_by_variance = 0;
    bool brief = false;     ///< also in tables for readers, whose width is limited
    bool unranked = false;  ///< also measured before the filter and against a method's own truth
    /// The id of the same without the truth's noise, which this one adds to the error of a perfect image; ""
    /// where it adds none.
    std::string_view without_noise = {};
};

/// The one table of metrics, in the order of columns.
const std::vector<Metric>& metrics();

/// Pixels of `candidate` where both images are finite. `nonfinite` receives how many were dropped for that.
Mask finite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate, std::size_t& nonfinite);

}  // namespace aoscore
