#include "jobs/job_cost.h"

#include <algorithm>

namespace aoscore {
namespace {

// Measured on the atrium at 1920x1080, 18 cells on two views in eight parts: of truths, of images and scores,
// and of times.
constexpr double kRay_s = 7e-8, kScoredPixel_s = 5e-7, kTimedPixel_s = 1.6e-6, kWrittenPixel_s = 1e-7;
// What most irradiances take to the error that they are traced to, steps included.
constexpr double kIrradianceRays = 450;

// The rays a pixel that settings ask for. Rays up to an error are not known before they are traced: a
// standard deviation of 0.3, which partly occluded pixels have, stands for all.
double rays(const TruthSettings& settings) {
    constexpr double kDeviation = 0.3;
    const double few = settings.samples;
    if (settings.max_error == 0) return few;
    return std::max(few, kDeviation * kDeviation / (settings.max_error * settings.max_error));
}

}  // namespace

double estimated_cost_s(const Job& job, const ViewWork& work) {
    const double pixels = static_cast<double>(work.width) * work.height;
    switch (job.kind) {
        case ArtifactKind::truth:
            return kRay_s * pixels * rays(work.truth) * static_cast<double>(work.queries.size());
        case ArtifactKind::own_truth:
            return kRay_s * pixels * rays(work.own_truth) * static_cast<double>(work.own_queries.size());
        case ArtifactKind::irradiance:
            return kRay_s * pixels * kIrradianceRays;
        case ArtifactKind::score:
        case ArtifactKind::own_score:
        case ArtifactKind::repeats:
            return kScoredPixel_s * pixels;
        case ArtifactKind::times:
        case ArtifactKind::gbuffer_times:
            return kTimedPixel_s * pixels;
        default:
            return kWrittenPixel_s * pixels;
    }
}

}  // namespace aoscore
