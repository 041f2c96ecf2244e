#include "scene/camera.h"

#include "core/error.h"
#include "core/image.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check(const Camera& c, int width, int height) {
    if (width < 1 || height < 1 || width > kLargestImageSide_px || height > kLargestImageSide_px) {
        throw usage_error(fmt::format("image size {}x{}", width, height), "size",
                          fmt::format("1x1 to {0}x{0}", kLargestImageSide_px));
    }
    if (!finite(c.position) || !finite(c.target) || !finite(c.up)) {
        throw usage_error("position, target or up is not finite", "camera");
    }
    const bool perspective = c.projection == Camera::Projection::perspective;
    if (perspective && !(c.fovy_rad > 0 && c.fovy_rad < std::numbers::pi)) {
        throw usage_error(fmt::format("fovy is {} rad", c.fovy_rad), "camera", "more than 0, less than pi");
    }
    if (!perspective && !(c.half_height > 0 && std::isfinite(c.half_height))) {
        throw usage_error(fmt::format("half height is {} m", c.half_height), "camera", "more than 0");
    }
    if (!(c.near > 0 && c.far > c.near && std::isfinite(c.far))) {
        throw usage_error(fmt::format("near {} m, far {} m", c.near, c.far), "camera",
                          "0 < near < far, finite");
    }
    if (glm::length(glm::cross(c.target - c.position, c.up)) == 0) {
        throw usage_error("the line of sight is zero or parallel to up", "camera");
    }
}

}  // namespace

CameraFrame::CameraFrame(const Camera& camera, int width, int height)
    : camera_(camera), width_(width), height_(height) {
    check(camera, width, height);
    const glm::dvec3 back = glm::normalize(camera.position - camera.target);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::normalize(camera.up), back));
    const glm::dvec3 up = glm::cross(back, right);
    world_from_view_ = glm::dmat4(glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(back, 0),
                                  glm::dvec4(camera.position, 1));
    const glm::dmat3 rotation = glm::transpose(glm::dmat3(right, up, back));
    view_from_world_ = glm::dmat4(rotation);
    view_from_world_[3] = glm::dvec4(-(rotation * camera.position), 1);

    const double aspect = static_cast<double>(width) / height;
    const double n = camera.near, f = camera.far;
    clip_from_view_ = glm::dmat4(0.0);
    if (camera.projection == Camera::Projection::perspective) {
        half_height_per_depth_ = std::tan(camera.fovy_rad / 2);
        half_width_per_depth_ = half_height_per_depth_ * aspect;
        clip_from_view_[0][0] = 1 / half_width_per_depth_;
        clip_from_view_[1][1] = 1 / half_height_per_depth_;
        clip_from_view_[2][2] = -(f + n) / (f - n);
        clip_from_view_[2][3] = -1;
        clip_from_view_[3][2] = -2 * f * n / (f - n);
    } else {
        half_height_per_depth_ = camera.half_height;
        half_width_per_depth_ = camera.half_height * aspect;
        clip_from_view_[0][0] = 1 / half_width_per_depth_;
        clip_from_view_[1][1] = 1 / half_height_per_depth_;
        clip_from_view_[2][2] = -2 / (f - n);
        clip_from_view_[3][2] = -(f + n) / (f - n);
        clip_from_view_[3][3] = 1;
    }
}

glm::dvec3 CameraFrame::view_position(double x, double y, double depth) const {
    const double scale = camera_.projection == Camera::Projection::perspective ? depth : 1.0;
    return {(2 * x / width_ - 1) * half_width_per_depth_ * scale,
            (1 - 2 * y / height_) * half_height_per_depth_ * scale, -depth};
}

CameraFrame::Ray CameraFrame::ray(double x, double y) const {
    const glm::dvec3 at_zero = view_position(x, y, 0);
    const glm::dvec3 per_depth = view_position(x, y, 1) - at_zero;
    return {glm::dvec3(world_from_view_ * glm::dvec4(at_zero, 1)), glm::dmat3(world_from_view_) * per_depth};
}

glm::dvec3 CameraFrame::project(const glm::dvec3& p) const {
    const double scale = camera_.projection == Camera::Projection::perspective ? -p.z : 1.0;
    return {(p.x / (half_width_per_depth_ * scale) + 1) / 2 * width_,
            (1 - p.y / (half_height_per_depth_ * scale)) / 2 * height_, -p.z};
}

double CameraFrame::pixel_footprint(double depth) const {
    const double scale = camera_.projection == Camera::Projection::perspective ? depth : 1.0;
    return 2 * half_height_per_depth_ * scale / height_;
}

double CameraFrame::view_depth(double window_depth) const {
    const double n = camera_.near, f = camera_.far;
    if (camera_.projection == Camera::Projection::orthographic) return n + window_depth * (f - n);
    return n * f / (f - window_depth * (f - n));
}

double CameraFrame::window_depth(double view_depth) const {
    const double n = camera_.near, f = camera_.far;
    if (camera_.projection == Camera::Projection::orthographic) return (view_depth - n) / (f - n);
    return f * (view_depth - n) / (view_depth * (f - n));
}

}  // namespace aoscore
