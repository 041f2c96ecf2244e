#include "screen/passes/line_sweep.h"

#include "core/threads.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace aoscore {
namespace {

constexpr double kPi = std::numbers::pi;

// A direction of the picture: the major axis goes by whole pixels, the minor one by `slope` a step. Every
// pixel lies on one line, which passes within half a pixel of its centre.
struct Direction {
    bool along_x = true;  // the major axis
    int step = 1;         // +1 or -1 along it
    double slope = 0;     // change of the minor axis for a major pixel (not a step)
    glm::dvec2 unit{1, 0};
};

Direction direction_of(int index, int count) {
    const double angle = 2 * kPi * (index + 0.5) / count;
    Direction d;
    d.unit = {std::cos(angle), std::sin(angle)};
    d.along_x = std::abs(d.unit.x) >= std::abs(d.unit.y);
    const double major = d.along_x ? d.unit.x : d.unit.y, minor = d.along_x ? d.unit.y : d.unit.x;
    d.step = major > 0 ? 1 : -1;
    d.slope = minor / major;
    return d;
}

// All points of a line of the picture lie in one plane through the eye; in it, z is the view depth and s the
// place along the line (perspective: tangent of the angle times depth).
struct PlanePoint {
    double s = 0;
    double depth = 0;
};

// Positive where c lies on the viewer's side of the line from a to b, with s increasing.
double toward_viewer(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b.depth - a.depth) * (c.s - a.s) - (b.s - a.s) * (c.depth - a.depth);
}

class Sweep {
  public:
    Sweep(const ProcessorInput& input, const Direction& direction, double edge)
        : in_(input),
          direction_(direction),
          edge_(edge),
          perspective_(input.frame->camera().projection == Camera::Projection::perspective) {}

    int line_count() const { return major_size() > 0 ? minor_size() + 2 * reach() : 0; }

    // Adds one side of the slice's visibility to every pixel of the line.
    void run(int line, ImageF& sum) const {
        const int offset = line - reach();
        std::vector<PlanePoint> hull;
        const int size = major_size();
        for (int i = 0; i < size; ++i) {
            const int major = direction_.step > 0 ? i : size - 1 - i;
            const double minor = offset + direction_.slope * (major - middle());
            const int nearest = static_cast<int>(std::lround(minor));
            if (nearest < 0 || nearest >= minor_size()) continue;
            const double depth = depth_on_line(major, minor, nearest);
            if (depth >= static_cast<double>(in_.background_depth)) continue;  // there is no occluder
            const PlanePoint point = plane_point(major, minor, depth);
            // Points below the tangent from the new point to the hull can never be a horizon again.
            while (hull.size() > 1 && toward_viewer(hull[hull.size() - 2], point, hull.back()) <= 0)
                hull.pop_back();
            const int x = direction_.along_x ? major : nearest, y = direction_.along_x ? nearest : major;
            if (in_.linear_depth->at(x, y) < in_.background_depth) {
                sum.at(x, y) += static_cast<float>(side_visibility(x, y, major, minor, point, hull));
            }
            hull.push_back(point);
        }
    }

  private:
    int major_size() const { return direction_.along_x ? in_.linear_depth->width : in_.linear_depth->height; }
    int minor_size() const { return direction_.along_x ? in_.linear_depth->height : in_.linear_depth->width; }
    // Lines are a pixel apart and pass through pixel centres here, so that mirrored directions have mirrored
    // lines.
    int middle() const { return (major_size() - 1) / 2; }
    // The greatest change of the minor axis from there to either side of the picture, pixels.
    int reach() const {
        return static_cast<int>(std::ceil(std::abs(direction_.slope) * (major_size() - middle()))) + 1;
    }

    double depth_at(int major, int minor) const {
        const int m = std::clamp(minor, 0, minor_size() - 1);
        return static_cast<double>(direction_.along_x ? in_.linear_depth->at(major, m)
                                                      : in_.linear_depth->at(m, major));
    }

    // The depth between the two pixels beside the line, on a plane through them; across an edge the nearer
    // pixel's.
    double depth_on_line(int major, double minor, int nearest) const {
        const double low = std::floor(minor), fraction = minor - low;
        const double a = depth_at(major, static_cast<int>(low)),
                     b = depth_at(major, static_cast<int>(low) + 1);
        if (std::abs(a - b) > edge_ * std::min(a, b)) return depth_at(major, nearest);
        return perspective_ ? 1 / std::lerp(1 / a, 1 / b, fraction) : std::lerp(a, b, fraction);
    }

    glm::dvec2 image_px(double major, double minor) const {
        return (direction_.along_x ? glm::dvec2(major, minor) : glm::dvec2(minor, major)) + 0.5;
    }

    // The direction in view space, in the picture plane.
    glm::dvec3 along() const { return {direction_.unit.x, -direction_.unit.y, 0}; }

    PlanePoint plane_point(int major, double minor, double depth) const {
        const glm::dvec2 px = image_px(major, minor);
        return {glm::dot(in_.frame->view_position(px.x, px.y, depth), along()), depth};
    }

    // The horizon lies on the side that was swept before, where the hull is.
    double side_visibility(int x, int y, int major, double minor, const PlanePoint& point,
                           const std::vector<PlanePoint>& hull) const {
        const glm::dvec2 px = image_px(major, minor);
        const glm::dvec3 position = in_.frame->view_position(px.x, px.y, point.depth);
        const glm::dvec3 view = perspective_ ? glm::normalize(-position) : glm::dvec3(0, 0, 1);
        const glm::dvec3 across = -along() + view * glm::dot(along(), view);
        const glm::dvec3 back = glm::normalize(across);
        // Directions are even in the picture; this is the angle that one of them spans about the view vector.
        const double share = view.z / glm::dot(across, across);
        const glm::dvec3 slice_normal = glm::cross(back, view);
        const glm::dvec3 normal(glm::vec3(in_.normal->at(x, y)));
        const glm::dvec3 in_slice = normal - slice_normal * glm::dot(normal, slice_normal);
        const double length = glm::length(in_slice);
        const double gamma = std::atan2(glm::dot(in_slice, back), glm::dot(in_slice, view));
        double horizon = gamma + kPi / 2;
        if (!hull.empty()) {
            // The plane's two axes in view space: along the picture, and straight ahead plus the tilt of the
            // line's plane.
            const glm::dvec3 ahead = depth_axis(position, point);
            const PlanePoint& h = hull.back();
            const glm::dvec3 v = along() * (h.s - point.s) + ahead * (h.depth - point.depth);
            horizon = std::min(horizon, std::acos(std::clamp(glm::dot(v, view) / glm::length(v), -1.0, 1.0)));
        }
        const double arc =
            (std::cos(gamma) + 2 * horizon * std::sin(gamma) - std::cos(2 * horizon - gamma)) / 4;
        return share * length * arc;
    }

    // The change of a point of the line's plane with depth at constant s: off the centre the plane through
    // the eye is tilted.
    glm::dvec3 depth_axis(const glm::dvec3& position, const PlanePoint& point) const {
        if (!perspective_) return {0, 0, -1};
        const glm::dvec3 ray = position / point.depth;
        return ray - along() * glm::dot(ray, along());
    }

    const ProcessorInput& in_;
    Direction direction_;
    double edge_;
    bool perspective_;
};

}  // namespace

ImageF line_sweep(const ProcessorInput& input, const ParameterValues& parameters) {
    const int directions = static_cast<int>(parameters.at("directions").number());
    const double edge = parameters.at("edge").number();
    // There is one picture for each direction, and they are added in order: the sum is the same for any
    // number of threads.
    std::vector<ImageF> sums(static_cast<std::size_t>(directions));
    ImageF result(input.linear_depth->width, input.linear_depth->height, 0);
    const std::size_t batch = static_cast<std::size_t>(std::max(thread_count(), 1)) * 2;
    for (std::size_t first = 0; first < sums.size(); first += batch) {
        const std::size_t count = std::min(batch, sums.size() - first);
        parallel_for(count, [&](std::size_t i) {
            ImageF& sum = sums[first + i];
            sum = ImageF(result.width, result.height, 0);
            const Sweep sweep(input, direction_of(static_cast<int>(first + i), directions), edge);
            for (int line = 0; line < sweep.line_count(); ++line) sweep.run(line, sum);
        });
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t p = 0; p < result.size(); ++p) result.pixels[p] += sums[first + i].pixels[p];
            sums[first + i] = ImageF();
        }
    }
    for (std::size_t p = 0; p < result.size(); ++p) {
        const bool background = input.linear_depth->pixels[p] >= input.background_depth;
        // Two sides make a slice.
        const float v = result.pixels[p] * 2 / static_cast<float>(directions);
        result.pixels[p] = background || v > 1 ? 1.0F : v;
    }
    return result;
}

double line_sweep_fetches(const ParameterValues& parameters) {
    return 2 * parameters.at("directions").number();
}

}  // namespace aoscore
