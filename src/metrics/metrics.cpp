#include "metrics/measures.h"
#include "metrics/over_views.h"

namespace aoscore {

const std::vector<Metric>& metrics() {
    using enum Metric::Better;
    static const std::vector<Metric> table = {
        {"rmse", "RMSE", "", lower,
         "Root of the mean squared difference from the truth, noise of the truth included.", "",
         measure::rmse, over_views::root_mean_square},
        {"rmse_debiased", "RMSE, debiased", "", lower,
         "RMSE with the mean variance of the truth's own noise taken off before the root: what ranks.", "",
         measure::rmse_debiased, over_views::root_mean_square},
        {"mae", "MAE", "", lower, "Mean absolute difference from the truth.", "", measure::mae,
         over_views::mean},
        {"bias", "Bias", "", nearer_zero,
         "Mean of test minus truth: above 0 the image is too bright, so that occlusion is missing.", "",
         measure::bias, over_views::mean},
        {"psnr", "PSNR", "dB", higher,
         "Peak signal-to-noise ratio, for a peak of 1: the RMSE on a logarithmic scale.", "", measure::psnr,
         over_views::decibels},
        {"ssim", "SSIM", "", higher,
         "Likeness of local brightness, contrast and structure in an 11x11 window, 1 when equal; hardly sees "
         "a "
         "uniform shift.",
         "Zhou Wang, Alan Bovik, Hamid Sheikh, Eero Simoncelli, Image Quality Assessment: From Error "
         "Visibility "
         "to Structural Similarity, 2004",
         measure::ssim, over_views::mean},
        {"max_error", "Max. error", "", lower, "Largest absolute difference, and the pixel that has it.", "",
         measure::max_error, over_views::largest},
        {"flip", "FLIP", "", lower,
         "Mean difference that a viewer sees who flips between the images, at 67.02 pixels per degree, with "
         "visibility shown as gray and taken as sRGB-coded.",
         "Pontus Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark "
         "Fairchild, "
         "FLIP: A Difference Evaluator for Alternating Images, 2020",
         measure::flip, over_views::mean},
        {"ms_ssim", "MS-SSIM", "", higher,
         "SSIM at five scales, each half the size of the one before, weighted as viewers weigh them.",
         "Zhou Wang, Eero Simoncelli, Alan Bovik, Multi-scale Structural Similarity for Image Quality "
         "Assessment, 2003",
         measure::ms_ssim, over_views::mean},
    };
    return table;
}

}  // namespace aoscore
