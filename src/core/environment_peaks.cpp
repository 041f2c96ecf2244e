#include "core/environment_peaks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;
/// Directions without preference see what is up to so many times the mean with little noise.
constexpr double kTimesMean = 4;

double mean_luminance(const EnvironmentMap& map) {
    double sum = 0;
    for (int y = 0; y < map.radiance.height; ++y) {
        for (int x = 0; x < map.radiance.width; ++x)
            sum += map.solid_angle(y) * luminance(glm::dvec3(map.radiance.at(x, y)));
    }
    return sum / (4 * kPi);
}

}  // namespace

EnvironmentPeaks::EnvironmentPeaks(const Environment& environment) : map_(environment.map()) {
    if (map_ == nullptr) return;
    limit_ = kTimesMean * mean_luminance(*map_);
    for (int y = 0; y < map_->radiance.height; ++y) {
        for (int x = 0; x < map_->radiance.width; ++x) {
            const double above = luminance(glm::dvec3(map_->radiance.at(x, y))) - limit_;
            if (above <= 0) continue;
            total_ += above * map_->solid_angle(y);
            texels_.push_back({x, y, total_});
        }
    }
    for (Texel& texel : texels_) texel.up_to /= total_;
}

glm::dvec3 EnvironmentPeaks::rest(const glm::dvec3& radiance) const {
    const double bright = luminance(radiance);
    return texels_.empty() || bright <= limit_ ? radiance : radiance * (limit_ / bright);
}

EnvironmentPeaks::Sample EnvironmentPeaks::sample(double u, double v) const {
    auto texel = std::ranges::lower_bound(texels_, u, {}, &Texel::up_to);
    if (texel == texels_.end()) --texel;
    const double before = texel == texels_.begin() ? 0 : std::prev(texel)->up_to;
    const double within = std::clamp((u - before) / (texel->up_to - before), 0.0, 1.0);
    const int width = map_->radiance.width, height = map_->radiance.height;
    // Even over the texel's solid angle: in the cosine to the zenith.
    const double cosine =
        std::lerp(std::cos(kPi * texel->y / height), std::cos(kPi * (texel->y + 1) / height), v);
    const double down = std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi;
    const glm::dvec3 radiance(map_->radiance.at(texel->x, texel->y));
    const double above = luminance(radiance) - limit_;
    return {map_->direction((texel->x + within) / width, down),
            (radiance - rest(radiance)) * (total_ / above)};
}

}  // namespace aoscore
