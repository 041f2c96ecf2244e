#include "jobs/pixel_facts.h"

#include "metrics/analysis/distance.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kEdgeStep_px = 2;

class DepthEdges {
  public:
    DepthEdges(const CameraFrame& frame, const PrimaryHits& hits) : frame_(frame), hits_(hits) {}

    Mask mask() const {
        Mask edges(frame_.width(), frame_.height());
        for (int y = 0; y < edges.height; ++y) {
            for (int x = 0; x < edges.width; ++x) {
                if (x + 1 < edges.width && is_edge(x, y, x + 1, y)) edges.at(x, y) = edges.at(x + 1, y) = 1;
                if (y + 1 < edges.height && is_edge(x, y, x, y + 1)) edges.at(x, y) = edges.at(x, y + 1) = 1;
            }
        }
        return edges;
    }

  private:
    bool is_edge(int x, int y, int nx, int ny) const {
        const bool here = hits_.surface.at(x, y) != 0, there = hits_.surface.at(nx, ny) != 0;
        if (!here || !there) return here != there;
        const glm::dvec3 offset = position(nx, ny) - position(x, y);
        const double nearest = std::min(hits_.depth.at(x, y), hits_.depth.at(nx, ny));
        const double step = kEdgeStep_px * frame_.pixel_footprint(nearest);
        return std::min(std::abs(glm::dot(offset, glm::dvec3(hits_.normal.at(x, y)))),
                        std::abs(glm::dot(offset, glm::dvec3(hits_.normal.at(nx, ny))))) > step;
    }

    glm::dvec3 position(int x, int y) const {
        return frame_.view_position(x + 0.5, y + 0.5, static_cast<double>(hits_.depth.at(x, y)));
    }

    const CameraFrame& frame_;
    const PrimaryHits& hits_;
};

ImageF tilts(const CameraFrame& frame, const PrimaryHits& hits) {
    ImageF tilt(frame.width(), frame.height());
    const bool perspective = frame.camera().projection == Camera::Projection::perspective;
    for (int y = 0; y < tilt.height; ++y) {
        for (int x = 0; x < tilt.width; ++x) {
            if (hits.surface.at(x, y) == 0) continue;
            const glm::dvec3 sight = perspective ? glm::normalize(frame.view_position(x + 0.5, y + 0.5, 1.0))
                                                 : glm::dvec3(0, 0, -1);
            const double cosine = std::abs(glm::dot(sight, glm::dvec3(hits.normal.at(x, y))));
            tilt.at(x, y) = static_cast<float>(std::min(cosine, 1.0));
        }
    }
    return tilt;
}

}  // namespace

PixelFacts pixel_facts(const CameraFrame& frame, const Truth& truth) {
    PixelFacts facts;
    facts.depth_m = truth.hits.depth;
    facts.tilt = tilts(frame, truth.hits);
    facts.edge_distance_px = distance_to(DepthEdges(frame, truth.hits).mask());
    for (std::size_t c = 0; c < kCauses; ++c) {
        if (truth.occlusion_by_cause[c].empty()) continue;
        facts.causes.push_back({std::string(kCauseIds[c]), &truth.occlusion_by_cause[c]});
    }
    if (!truth.one_layer_bound.empty()) facts.one_layer = &truth.one_layer_bound;
    return facts;
}

}  // namespace aoscore
