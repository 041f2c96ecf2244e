#include "jobs/camera_contract.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kPlaneTolerance_px = 1.0 / 16.0;
constexpr double kFloatTolerance = 2e-6;
constexpr double kEdgeStep_px = 2.0;
constexpr double kEdgeCosine = 0.9;

class EdgeFinder {
  public:
    EdgeFinder(const CameraFrame& frame, const PrimaryHits& hits) : frame_(frame), hits_(hits) {}

    bool is_edge(int x, int y) const {
        if (hits_.surface.at(x, y) == 0) return has_surface_neighbour(x, y);
        const glm::dvec3 position = view_position(x, y);
        const glm::dvec3 normal(hits_.normal.at(x, y));
        const double step = kEdgeStep_px * frame_.pixel_footprint(-position.z);
        return any_neighbour(x, y, [&](int nx, int ny) {
            if (hits_.surface.at(nx, ny) == 0) return true;
            const glm::dvec3 offset = view_position(nx, ny) - position;
            return std::abs(glm::dot(offset, normal)) > step ||
                   glm::dot(normal, glm::dvec3(hits_.normal.at(nx, ny))) < kEdgeCosine;
        });
    }

  private:
    glm::dvec3 view_position(int x, int y) const {
        return frame_.view_position(x + 0.5, y + 0.5, static_cast<double>(hits_.depth.at(x, y)));
    }

    bool has_surface_neighbour(int x, int y) const {
        return any_neighbour(x, y, [&](int nx, int ny) { return hits_.surface.at(nx, ny) != 0; });
    }

    template <class Predicate>
    bool any_neighbour(int x, int y, Predicate predicate) const {
        for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, frame_.height() - 1); ++ny) {
            for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, frame_.width() - 1); ++nx) {
                if ((nx != x || ny != y) && predicate(nx, ny)) return true;
            }
        }
        return false;
    }

    const CameraFrame& frame_;
    const PrimaryHits& hits_;
};

bool same_surface(const CameraFrame& frame, const PrimaryHits& hits, const ImageF& drawn_depth_m, int x,
                  int y, double float_tolerance_m) {
    const auto traced = static_cast<double>(hits.depth.at(x, y));
    const auto drawn = static_cast<double>(drawn_depth_m.at(x, y));
    const glm::dvec3 offset =
        frame.view_position(x + 0.5, y + 0.5, drawn) - frame.view_position(x + 0.5, y + 0.5, traced);
    const double plane_distance = std::abs(glm::dot(offset, glm::dvec3(hits.normal.at(x, y))));
    return plane_distance <= std::max(kPlaneTolerance_px * frame.pixel_footprint(traced), float_tolerance_m);
}

}  // namespace

double CameraContract::disagreeing_share() const {
    const std::size_t compared = valid_count + disagreeing;
    return compared > 0 ? static_cast<double>(disagreeing) / static_cast<double>(compared) : 0.0;
}

std::string emptiness(std::size_t surface_pixels, std::size_t valid_pixels) {
    if (valid_pixels > 0) return "";
    return surface_pixels == 0 ? "the camera sees no surface: there is nothing to compare"
                               : "ray tracer and rasteriser see the same surface through no pixel";
}

CameraContract check_camera_contract(const CameraFrame& frame, const PrimaryHits& hits,
                                     const GBufferImages& gbuffer, double scene_extent_m) {
    CameraContract contract;
    contract.valid = Mask(frame.width(), frame.height());
    const EdgeFinder edges(frame, hits);
    const ImageF& drawn_depth_m = gbuffer.linear_depth();
    for (int y = 0; y < frame.height(); ++y) {
        for (int x = 0; x < frame.width(); ++x) {
            const bool traced = hits.surface.at(x, y) != 0, drawn = gbuffer.surface.at(x, y) != 0;
            if (!traced && !drawn) continue;
            ++contract.surface;
            const bool edge = edges.is_edge(x, y);
            contract.edges += edge;
            if (traced && drawn &&
                same_surface(frame, hits, drawn_depth_m, x, y, kFloatTolerance * scene_extent_m)) {
                contract.valid.at(x, y) = 1;
                ++contract.valid_count;
            } else {
                contract.disagreeing += !edge;
            }
        }
    }
    return contract;
}

}  // namespace aoscore
