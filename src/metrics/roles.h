#pragma once

namespace aoscore {

/// The metrics that have a part to play beside being a column, each by its part: ids of the table of metrics.
/// No other file names a metric.
inline constexpr char kRankingMetric[] = "rmse_debiased";  ///< ranks where the truth's noise is known
inline constexpr char kNoisyRankingMetric[] = "rmse";      ///< ranks elsewhere, the noise included
inline constexpr char kBiasMetric[] = "bias";              ///< says which way a method errs
inline constexpr char kStructureMetric[] = "ssim";         ///< likeness, shown beside the error
inline constexpr char kPerceptualMetric[] = "flip";        ///< what viewers see, shown beside the error

}  // namespace aoscore
