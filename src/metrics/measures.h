#pragma once

#include "metrics/metric.h"

/// The functions behind the table in metrics.cpp, each in the file of its name. All of them average over the
/// valid pixels, in double precision and in an order that does not depend on the number of threads. All
/// return an empty value with a note where they are undefined, and throw sizes_differ for images of several
/// sizes.
namespace aoscore::measure {

MetricValue rmse(const MetricInput& input);
MetricValue rmse_debiased(const MetricInput& input);
MetricValue mae(const MetricInput& input);
MetricValue bias(const MetricInput& input);
MetricValue psnr(const MetricInput& input);
MetricValue ssim(const MetricInput& input);
MetricValue max_error(const MetricInput& input);
MetricValue flip(const MetricInput& input);
MetricValue ms_ssim(const MetricInput& input);

}  // namespace aoscore::measure
