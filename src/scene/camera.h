#pragma once

#include <glm/glm.hpp>

#include <string>

namespace aoscore {

/// The one place that owns rays and matrices: every path (ray tracer, rasteriser, masks by cause) asks here,
/// so that a half pixel, a flip or a handedness cannot differ between them.
///
/// View space is right-handed, the camera looks down -z, x to the right, y up. Pixel (0,0) is the top left
/// one of the image, its centre at (0.5, 0.5). Depth is OpenGL's: window depth 0 at the near, 1 at the far
/// plane.
struct Camera {
    enum class Projection { perspective, orthographic };

    Projection projection = Projection::perspective;
    glm::dvec3 position{0, 0, 0};  ///< in metres, scene space
    glm::dvec3 target{0, 0, -1};   ///< any point ahead, not `position`
    glm::dvec3 up{0, 1, 0};        ///< not parallel to the line of sight; need not be unit or perpendicular
    double fovy_rad = 0.9;         ///< perspective: full vertical angle of view, in (0, pi)
    double half_height = 1.0;      ///< orthographic: half the picture's height, metres, > 0
    double near = 0.1;             ///< metres, > 0
    double far = 1000.0;           ///< metres, > near, finite

    bool operator==(const Camera&) const = default;
};

/// A camera at one image size, with its rays and matrices. Immutable.
class CameraFrame {
  public:
    /// Throws usage_error for a size below 1x1 or a camera that has no picture (target at position, ...).
    CameraFrame(const Camera& camera, int width, int height);

    const Camera& camera() const { return camera_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Holds rotation and translation only; its determinant is 1.
    const glm::dmat4& view_from_world() const { return view_from_world_; }
    const glm::dmat4& world_from_view() const { return world_from_view_; }
    /// Leads to OpenGL's clip space, z from -w (near) to w (far).
    const glm::dmat4& clip_from_view() const { return clip_from_view_; }

    struct Ray {
        glm::dvec3 origin;     ///< world; on the camera (perspective) or its plane (orthographic)
        glm::dvec3 direction;  ///< world; scaled so that t is the view depth -z, not the distance
    };
    /// The ray through image position (x, y) in pixels: a centre is at (column + 0.5, row + 0.5), y
    /// downwards. Its points with t in [near, far] are in the picture.
    Ray ray(double x, double y) const;

    /// View-space position at image position (x, y) px and view depth `depth` = -z, metres.
    glm::dvec3 view_position(double x, double y, double depth) const;
    /// Image position in px (x, y) and view depth (z) of a view-space point. The perspective result is
    /// meaningless for depth <= 0.
    glm::dvec3 project(const glm::dvec3& view_position) const;

    /// Height of one pixel at view depth `depth`, metres.
    double pixel_footprint(double depth) const;
    /// A world length seen face-on at view depth `depth`, in pixels: R_px = R H / (2 |z| tan(fovy/2)).
    double pixels_per_metre(double depth) const { return 1.0 / pixel_footprint(depth); }

    /// Convert window depth in [0,1] to view depth in metres, and back.
    double view_depth(double window_depth) const;
    double window_depth(double view_depth) const;

  private:
    Camera camera_;
    int width_;
    int height_;
    double half_width_per_depth_;  // perspective: tan(half angle); orthographic: half extent
    double half_height_per_depth_;
    glm::dmat4 view_from_world_;
    glm::dmat4 world_from_view_;
    glm::dmat4 clip_from_view_;
};

}  // namespace aoscore
