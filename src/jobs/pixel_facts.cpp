#include "jobs/pixel_facts.h"

#include "metrics/analysis/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aoscore {
namespace {

constexpr double kEdgeStep_px = 2;

class DepthEdges {
  public:
    DepthEdges(const CameraFrame& frame, const PrimaryHits& hits) : frame_(frame), hits_(hits) {}

    /// The pixels on the near and on the far side of an edge.
    struct Sides {
        Mask near, far;
    };
    Sides sides() const {
        Sides sides{Mask(frame_.width(), frame_.height()), Mask(frame_.width(), frame_.height())};
        for (int y = 0; y < frame_.height(); ++y) {
            for (int x = 0; x < frame_.width(); ++x) {
                if (x + 1 < frame_.width() && is_edge(x, y, x + 1, y)) mark(sides, {x, y}, {x + 1, y});
                if (y + 1 < frame_.height() && is_edge(x, y, x, y + 1)) mark(sides, {x, y}, {x, y + 1});
            }
        }
        return sides;
    }

  private:
    void mark(Sides& sides, glm::ivec2 a, glm::ivec2 b) const {
        const auto depth = [&](glm::ivec2 p) {
            constexpr float kBackground = std::numeric_limits<float>::infinity();
            return hits_.surface.at(p.x, p.y) != 0 ? hits_.depth.at(p.x, p.y) : kBackground;
        };
        if (depth(a) > depth(b)) std::swap(a, b);
        sides.near.at(a.x, a.y) = sides.far.at(b.x, b.y) = 1;
    }
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
    const DepthEdges::Sides sides = DepthEdges(frame, truth.hits).sides();
    facts.behind_edge_px = distance_to(sides.far);
    facts.edge_distance_px = distance_to(sides.near);
    for (std::size_t i = 0; i < facts.edge_distance_px.size(); ++i) {
        float& edge_px = facts.edge_distance_px.pixels[i];
        edge_px = std::min(edge_px, facts.behind_edge_px.pixels[i]);
    }
    for (std::size_t c = 0; c < kCauses; ++c) {
        if (truth.occlusion_by_cause[c].empty()) continue;
        facts.causes.push_back({std::string(kCauseIds[c]), &truth.occlusion_by_cause[c]});
    }
    if (!truth.one_layer_bound.empty()) facts.one_layer = &truth.one_layer_bound;
    return facts;
}

}  // namespace aoscore
