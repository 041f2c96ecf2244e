#include "jobs/recorded/frame_depth.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

bool is_window(DepthKind kind) {
    return kind == DepthKind::window || kind == DepthKind::reversed_window;
}

// View depth of every pixel, infinite on background.
double view_depth_of(double stored, DepthKind kind, double unit_m, const CameraFrame& frame, int x, int y) {
    switch (kind) {
        case DepthKind::view:
            return stored * unit_m;
        case DepthKind::negative_view:
            return -stored * unit_m;
        case DepthKind::distance: {
            const bool perspective = frame.camera().projection == Camera::Projection::perspective;
            const double slant = perspective ? glm::length(frame.view_position(x + 0.5, y + 0.5, 1.0)) : 1.0;
            return stored * unit_m / slant;
        }
        case DepthKind::window:
            return stored < 1 ? frame.view_depth(stored) : kNone;
        case DepthKind::reversed_window:
            return stored > 0 ? frame.view_depth(1 - stored) : kNone;
    }
    return kNone;
}

/// The same of a perspective depth buffer without a far plane: as far / (far - near) tends to 1, window depth
/// is 1 - near / depth.
double view_depth_without_far(double stored, DepthKind kind, double near) {
    const double from_far = kind == DepthKind::reversed_window ? stored : 1 - stored;
    return from_far > 0 ? near / from_far : kNone;
}

/// Refuses what no depth of this kind can be.
void require_plausible(const ImageF& stored, DepthKind kind, double background_from,
                       const std::string& where) {
    std::size_t nan = 0, negative = 0, beyond_window = 0, counted = 0;
    for (const float value : stored.pixels) {
        nan += std::isnan(value);
        if (!std::isfinite(value) || (background_from > 0 && double{value} >= background_from)) continue;
        ++counted;
        negative += value < 0;
        beyond_window += value < 0 || value > 1;
    }
    if (nan > 0)
        throw file_error(fmt::format("{} of {} depths are NaN", nan, stored.size()), where,
                         "a depth in every pixel; infinite where there is no surface");
    if (is_window(kind)) {
        if (beyond_window > 0)
            throw file_error(fmt::format("{} depths lie outside of 0 to 1, so that this is no depth buffer",
                                         beyond_window),
                             where, R"("depth": "view" or "distance" in the camera file, where it is one)");
        return;
    }
    const std::size_t wrong = kind == DepthKind::negative_view ? counted - negative : negative;
    if (2 * wrong > counted)
        throw file_error(
            fmt::format("{} of {} depths are {}", wrong, counted,
                        kind == DepthKind::negative_view ? "positive or 0" : "negative"),
            where,
            kind == DepthKind::negative_view
                ? R"("depth": "view" in the camera file)"
                : R"(depth that grows away from the camera; "depth": "negative-view" in the camera file where it is z)");
}

/// Chooses planes around all surfaces.
void choose_planes(const Image<double>& depths, Camera& camera) {
    double least = kNone, most = 0;
    for (const double depth : depths.pixels) {
        if (!std::isfinite(depth) || depth <= 0) continue;
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    camera.near = most > 0 ? least / 2 : 0.1;
    camera.far = most > 0 ? most * 2 : 1000;
}

// Background that is stored as a depth lies on the far plane to the rounding of a float.
constexpr double kOnFarPlane = 1e-6;

void require_between_planes(const Image<double>& depths, const FrameDepth& result, const std::string& where) {
    const double far = result.frame.camera().far;
    std::vector<double> finite;
    std::size_t within = 0;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        within += result.surface.pixels[i];
        const double depth = depths.pixels[i];
        const bool background = std::abs(depth - far) <= kOnFarPlane * far;
        if (std::isfinite(depth) && depth > 0 && !background) finite.push_back(depth);
    }
    const Camera& camera = result.frame.camera();
    if (finite.empty()) throw file_error("shows no surface", where, "a depth above 0 somewhere");
    if (within * 2 > finite.size()) return;
    const auto middle = finite.begin() + static_cast<std::ptrdiff_t>(finite.size() / 2);
    std::nth_element(finite.begin(), middle, finite.end());
    throw file_error(
        fmt::format("{} of {} depths lie between the near plane at {:g} m and the far plane at {:g} "
                    "m; the median is {:.4g} m: another unit, or another kind of depth",
                    within, finite.size(), camera.near, camera.far, *middle),
        where, R"(metres, or "unit" and "depth" in the camera file)");
}

}  // namespace

FrameDepth frame_depth(const ImageF& stored, DepthKind kind, double background_from,
                       const FrameCamera& described, const std::string& where) {
    require_plausible(stored, kind, background_from, where);
    if (is_window(kind) && !described.has_planes)
        throw file_error("is a depth buffer, whose near and far plane are not known", where,
                         "near_m and far_m in the camera file");
    Camera camera = described.camera;
    const CameraFrame rays(camera, stored.width, stored.height);
    Image<double> depths(stored.width, stored.height, kNone);
    for (int y = 0; y < stored.height; ++y) {
        for (int x = 0; x < stored.width; ++x) {
            const auto value = double{stored.at(x, y)};
            if (!std::isfinite(value) || (background_from > 0 && value >= background_from)) continue;
            depths.at(x, y) = is_window(kind) && described.infinite_far
                                  ? view_depth_without_far(value, kind, camera.near)
                                  : view_depth_of(value, kind, described.metres_per_unit, rays, x, y);
        }
    }
    if (!described.has_planes || described.infinite_far) choose_planes(depths, camera);
    FrameDepth result{CameraFrame(camera, stored.width, stored.height),
                      ImageF(stored.width, stored.height, static_cast<float>(camera.far)),
                      ImageF(stored.width, stored.height, 1.0F), Mask(stored.width, stored.height)};
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const auto depth = static_cast<float>(depths.pixels[i]);
        if (!(double{depth} >= camera.near * (1 - 1e-6) && depth < static_cast<float>(camera.far))) continue;
        result.surface.pixels[i] = 1;
        result.view_depth.pixels[i] = depth;
        result.window_depth.pixels[i] = static_cast<float>(result.frame.window_depth(double{depth}));
    }
    require_between_planes(depths, result, where);
    return result;
}

}  // namespace aoscore
