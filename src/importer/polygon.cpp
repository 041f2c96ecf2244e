#include "importer/polygon.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace aoscore::importer {
namespace {

/// Newell's method (Sutherland, Sproull and Schumacker, "A Characterization of Ten Hidden-Surface
/// Algorithms", 1974): twice the polygon's projected areas. Positions are relative to a corner, so that a
/// distant origin costs no digits.
glm::dvec3 normal_of(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    return sum;
}

/// The corners as seen along the axis that the normal is closest to, counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int along = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (along + 1) % 3, v = (along + 2) % 3;
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p = corner - corners[0];
        flat.push_back(normal[along] < 0 ? glm::dvec2(p[v], p[u]) : glm::dvec2(p[u], p[v]));
    }
    return flat;
}

/// Twice the area of a triangle, positive counter-clockwise.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The rest of a polygon while its ears are cut off.
class Rest {
  public:
    explicit Rest(std::vector<glm::dvec2> corners) : corners_(std::move(corners)) {
        const auto n = static_cast<unsigned>(corners_.size());
        for (unsigned i = 0; i < n; ++i) {
            next_.push_back((i + 1) % n);
            previous_.push_back((i + n - 1) % n);
        }
    }

    unsigned next(unsigned i) const { return next_[i]; }
    glm::uvec3 triangle(unsigned i) const { return {previous_[i], i, next_[i]}; }

    double area_at(unsigned i) const { return area(corners_[previous_[i]], corners_[i], corners_[next_[i]]); }

    /// Whether the triangle at a corner lies inside: it turns to the left, and no other corner is in it.
    /// (Corners at the same place as its own, where a seam joins a hole, do not count.)
    bool is_ear(unsigned i) const {
        if (!(area_at(i) > 0)) return false;
        const glm::dvec2 &a = corners_[previous_[i]], &b = corners_[i], &c = corners_[next_[i]];
        for (unsigned k = next_[next_[i]]; k != previous_[i]; k = next_[k]) {
            const glm::dvec2& p = corners_[k];
            if (p == a || p == b || p == c || area_at(k) > 0) continue;  // a right turn is nearer
            if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
        }
        return true;
    }

    void remove(unsigned i) {
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
    }

  private:
    std::vector<glm::dvec2> corners_;
    std::vector<unsigned> next_, previous_;
};

bool is_convex(const Rest& rest, unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
        if (rest.area_at(i) < 0) return false;
    }
    return true;
}

}  // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::dvec3> corners) {
    std::vector<glm::uvec3> triangles;
    const auto count = static_cast<unsigned>(corners.size());
    if (count < 3) return triangles;
    triangles.reserve(count - 2);
    if (count == 3) return {{0, 1, 2}};
    Rest rest(flatten(corners, normal_of(corners)));
    if (is_convex(rest, count)) {
        for (unsigned i = 2; i < count; ++i) triangles.emplace_back(0, i - 1, i);
        return triangles;
    }
    unsigned at = 0, left = count, since_last = 0;
    while (left > 3) {
        // A polygon that crosses itself may have no ear: any corner is cut off then.
        if (rest.is_ear(at) || since_last > left) {
            triangles.push_back(rest.triangle(at));
            rest.remove(at);
            --left;
            since_last = 0;
        } else {
            ++since_last;
        }
        at = rest.next(at);
    }
    triangles.push_back(rest.triangle(at));
    return triangles;
}

}  // namespace aoscore::importer
