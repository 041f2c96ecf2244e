#pragma once

namespace aoscore {

/// The ids of metrics that have a role beside being a column. No other file names a metric.
inline constexpr char kRankingMetric[] = "rmse_debiased";  ///< ranks where the truth's noise is known
inline constexpr char kNoisyRankingMetric[] = "rmse";      ///< ranks elsewhere, the noise included
inline constexpr char kBiasMetric[] = "bias";              ///< shows the sign of a method's error
inline constexpr char kStructureMetric[] = "ssim";         ///< likeness, shown beside the error
inline constexpr char kPerceptualMetric[] = "flip";        ///< perceived difference, shown beside the error
inline constexpr char kBentAngleMetric[] = "bent_angle_mean";  ///< of the signal "bent_normal"
inline constexpr char kConeErrorMetric[] = "cone_error_mean";  ///< of the signal "cone_angle"
inline constexpr char kConeBiasMetric[] = "cone_bias";         ///< shows the sign of a cone's error

}  // namespace aoscore
