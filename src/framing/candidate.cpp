#include "framing/candidate.h"

#include "core/threads.h"
#include "scene/depth_range.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr int kHeight_px = 27;
constexpr int kRays = 8;

bool is_within(const Bounds& box, const glm::dvec3& p) {
    const glm::dvec3 slack(1e-6 * box.diagonal());
    return glm::all(glm::greaterThanEqual(p, box.low - slack)) &&
           glm::all(glm::lessThanEqual(p, box.high + slack));
}

double worth_of(const Glance& glance, const MainPart& main, double close_m) {
    // Beyond this share of covered pixels a picture from outside is not worth more.
    constexpr double kCovered = 0.5, kLeastVariety = 0.1, kBackFace = 0.25;
    const auto count = static_cast<double>(glance.points.size());
    if (count == 0) return 0;
    double sum = 0, squares = 0, of_main = 0, fronts = 0, close = 0;
    for (const Glance::Point& p : glance.points) {
        sum += p.visibility;
        squares += p.visibility * p.visibility;
        of_main += is_within(main.bounds, p.position);
        fronts += p.front;
        close += p.depth_m < close_m;
    }
    const double variety = std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
    const double far = 1 - close / count;
    return (kLeastVariety + variety) * std::min(glance.coverage(), kCovered) * (of_main / count) *
           (kBackFace + (1 - kBackFace) * fronts / count) * far * far;
}

/// Sets near and far so that the camera sees things just before it, and all of the scene.
void set_depth_range(Camera& camera, const Bounds& bounds, double near) {
    const DepthRange range = useful_depth_range(camera, bounds, near, 0);
    camera.near = range.near;
    camera.far = range.far;
}

void try_camera(const Trial& trial, double close_m, Candidate& candidate) {
    // Between the pixels of the trial there may be things that are nearer than all of them.
    constexpr double kNearPerNearest = 0.2;
    set_depth_range(candidate.camera, trial.bounds, 0);
    const int width = std::max(1, static_cast<int>(std::lround(kHeight_px * trial.aspect)));
    candidate.glance =
        trial.scout.look(CameraFrame(candidate.camera, width, kHeight_px), trial.radius_m, kRays);
    candidate.worth = worth_of(candidate.glance, trial.main, close_m);
    if (candidate.glance.points.empty()) return;
    const auto nearest = std::ranges::min_element(candidate.glance.points, {}, &Glance::Point::depth_m);
    set_depth_range(candidate.camera, trial.bounds, kNearPerNearest * nearest->depth_m);
}

}  // namespace

void try_cameras(const Trial& trial, double close_m, std::vector<Candidate>& candidates) {
    parallel_for(candidates.size(), [&](std::size_t i) { try_camera(trial, close_m, candidates[i]); });
}

const Candidate& best_of(const std::vector<Candidate>& candidates) {
    constexpr double kSwappable = 0.01;
    const double best = std::ranges::max_element(candidates, {}, &Candidate::worth)->worth;
    return *std::ranges::find_if(candidates,
                                 [&](const Candidate& c) { return c.worth >= best * (1 - kSwappable); });
}

}  // namespace aoscore
