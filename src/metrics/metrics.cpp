#include "metrics/intervals/drawn_sums.h"
#include "metrics/intervals/over_views.h"
#include "metrics/measures.h"

#include <cmath>

namespace aoscore {

const std::vector<Metric>& metrics() {
    using enum Metric::Better;
    using enum Metric::Noise;
    static const std::vector<Metric> table = {
        {.id = "rmse",
         .label = "RMSE",
         .in_text = "RMSE",
         .better = lower,
         .meaning = "Root of the mean squared difference from the truth, noise of the truth included.",
         .measure = measure::rmse,
         .over_views = over_views::root_mean_square,
         .resampled = [](const DrawnSums& s) { return std::sqrt(s.squared / s.count); },
         .brief = true,
         .unranked = true,
         .without_noise = "rmse_debiased"},
        {.id = "rmse_debiased",
         .label = "RMSE, debiased",
         .in_text = "debiased RMSE",
         .better = lower,
         .meaning =
             "RMSE with the mean variance of the truth's own noise taken off before the root: what ranks.",
         .measure = measure::rmse_debiased,
         .over_views = over_views::root_mean_square,
         .resampled =
             [](const DrawnSums& s) {
                 const double mse = (s.squared - s.variance) / s.count;
                 return mse < 0 ? 0.0 : std::sqrt(mse);  // not std::max, which would turn NaN into 0
             },
         .noise = taken_off,
         .brief = true,
         .unranked = true},
        {.id = "mae",
         .label = "MAE",
         .in_text = "MAE",
         .better = lower,
         .meaning = "Mean absolute difference from the truth.",
         .measure = measure::mae,
         .over_views = over_views::mean,
         .resampled = [](const DrawnSums& s) { return s.absolute / s.count; },
         .noise = extrapolated,
         .left_by_deviation = 6,
         .unranked = true},
        {.id = "bias",
         .label = "Bias",
         .in_text = "bias",
         .better = nearer_zero,
         .meaning =
             "Mean of test minus truth: above 0 the image is too bright, so that occlusion is missing.",
         .measure = measure::bias,
         .over_views = over_views::mean,
         .resampled = [](const DrawnSums& s) { return s.difference / s.count; },
         .noise = taken_off,
         .brief = true,
         .unranked = true},
        {.id = "psnr",
         .label = "PSNR",
         .in_text = "PSNR",
         .unit = "dB",
         .better = higher,
         .decimals = 2,
         .meaning = "Peak signal-to-noise ratio, for a peak of 1: the RMSE on a logarithmic scale.",
         .measure = measure::psnr,
         .over_views = over_views::decibels,
         .resampled = [](const DrawnSums& s) { return -10 * std::log10(s.squared / s.count); }},
        {.id = "ssim",
         .label = "SSIM",
         .in_text = "SSIM",
         .better = higher,
         .meaning = "Likeness of local brightness, contrast and structure in an 11x11 window, 1 when equal; "
                    "hardly sees a uniform shift.",
         .paper = "Zhou Wang, Alan Bovik, Hamid Sheikh, Eero Simoncelli, Image Quality Assessment: From "
                  "Error Visibility to Structural Similarity, 2004",
         .measure = measure::ssim,
         .over_views = over_views::mean,
         .resampled = [](const DrawnSums& s) { return s.ssim / s.ssim_weight; },
         .noise = extrapolated,
         .left_by_noise = 0.48,
         .most_noise_variance = 3e-4,
         .brief = true,
         .unranked = true},
        {.id = "max_error",
         .label = "Max. error",
         .in_text = "largest error",
         .better = lower,
         .meaning = "Largest absolute difference, and the pixel that has it.",
         .measure = measure::max_error,
         .over_views = over_views::largest,
         .resampled = nullptr},  // resampled blocks never hold a larger error
        {.id = "flip",
         .label = "FLIP",
         .in_text = "FLIP",
         .better = lower,
         .meaning = "Mean difference that a viewer sees who flips between the images, at 67.02 pixels per "
                    "degree, with visibility shown as gray and taken as sRGB-coded.",
         .paper = "Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, "
                  "Mark Fairchild, FLIP: A Difference Evaluator for Alternating Images, 2020",
         .measure = measure::flip,
         .over_views = over_views::mean,
         .resampled = [](const DrawnSums& s) { return s.flip / s.count; },
         .noise = extrapolated,
         .left_always = 0.25,
         .brief = true},
        {.id = "ms_ssim",
         .label = "MS-SSIM",
         .in_text = "MS-SSIM",
         .better = higher,
         .meaning =
             "SSIM at five scales, each half the size of the one before, weighted as viewers weigh them.",
         .paper = "Zhou Wang, Eero Simoncelli, Alan Bovik, Multi-scale Structural Similarity for Image "
                  "Quality Assessment, 2003",
         .measure = measure::ms_ssim,
         .over_views = over_views::mean,
         .resampled = [](const DrawnSums& s) { return s.ms_ssim; },
         .noise = extrapolated,
         .left_by_deviation = 34,
         .most_noise_variance = 3e-4},
    };
    return table;
}

}  // namespace aoscore
