#include "framing/main_part.h"

#include "framing/spread_direction.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFence = 3;  // in distances between the quartiles
constexpr double kLeastPart = 0.5;
constexpr std::size_t kSampledTriangles = 200'000;
constexpr std::size_t kOutlineTriangles = 200'000;
constexpr int kOutlineDirections = 256;

using Corners = std::array<glm::dvec3, 3>;

void for_each_triangle(const Scene& scene, std::size_t step,
                       const std::function<void(const Corners&)>& visit) {
    std::size_t number = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const glm::uvec3& t : mesh.triangles) {
            if (number++ % step != 0) continue;
            Corners corners;
            for (int i = 0; i < 3; ++i)
                corners[static_cast<std::size_t>(i)] =
                    glm::dvec3(instance.scene_from_mesh * glm::dvec4(mesh.positions[t[i]], 1));
            visit(corners);
        }
    }
}

double edges_of(const Corners& c) {
    return glm::distance(c[0], c[1]) + glm::distance(c[1], c[2]) + glm::distance(c[2], c[0]);
}

struct WeightedPlace {
    double place, weight;
};

/// The value at which the sum of the weights reaches this share of their total.
double quantile(const std::vector<WeightedPlace>& sorted, double total, double share) {
    double sum = 0;
    for (const WeightedPlace& p : sorted) {
        sum += p.weight;
        if (sum >= share * total) return p.place;
    }
    return sorted.back().place;
}

/// The box that main triangles lie in.
Bounds fences(const Scene& scene) {
    std::array<std::vector<WeightedPlace>, 3> places;
    double total = 0;
    for_each_triangle(scene, scene.triangle_count / kSampledTriangles + 1, [&](const Corners& corners) {
        const double weight = edges_of(corners);
        total += 3 * weight;
        for (const glm::dvec3& p : corners) {
            for (int axis = 0; axis < 3; ++axis)
                places[static_cast<std::size_t>(axis)].push_back({p[axis], weight});
        }
    });
    glm::dvec3 low(-kInfinity), high(kInfinity);
    double widest = 0;
    if (!(total > 0)) return {low, high};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<WeightedPlace>& along = places[static_cast<std::size_t>(axis)];
        std::ranges::sort(along, {}, &WeightedPlace::place);
        low[axis] = quantile(along, total, 0.25);
        high[axis] = quantile(along, total, 0.75);
        widest = std::max(widest, high[axis] - low[axis]);
    }
    return {low - kFence * widest, high + kFence * widest};
}

bool lies_in(const Bounds& box, const Corners& corners) {
    return std::ranges::all_of(corners, [&](const glm::dvec3& p) {
        return glm::all(glm::greaterThanEqual(p, box.low)) && glm::all(glm::lessThanEqual(p, box.high));
    });
}

/// The furthest points along each of some directions, found one after the other.
class Outermost {
  public:
    explicit Outermost(std::vector<glm::dvec3> directions)
        : directions_(std::move(directions)),
          reach_(directions_.size(), -kInfinity),
          points_(directions_.size()) {}

    void include(const glm::dvec3& p) {
        for (std::size_t i = 0; i < directions_.size(); ++i) {
            const double reach = glm::dot(directions_[i], p);
            if (reach <= reach_[i]) continue;
            reach_[i] = reach;
            points_[i] = p;
        }
    }
    const std::vector<glm::dvec3>& points() const { return points_; }

  private:
    std::vector<glm::dvec3> directions_;
    std::vector<double> reach_;
    std::vector<glm::dvec3> points_;
};

/// The axes and the diagonals between them.
std::vector<glm::dvec3> grid_directions() {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (d != glm::dvec3(0)) directions.push_back(d);
    }
    return directions;
}

std::vector<glm::dvec3> spread_directions() {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < kOutlineDirections; ++i)
        directions.push_back(spread_direction({0, 1, 0}, -1, i, kOutlineDirections));
    return directions;
}

/// The part made of the triangles in the box; `edges` becomes the total length of their edges.
MainPart part_within(const Scene& scene, const Bounds& box, double& edges, double& all_edges) {
    MainPart part{{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)}, {}};
    // No corner that stands out is missed; of a fine mesh, some of the others suffice.
    Outermost corners(grid_directions()), others(spread_directions());
    const std::size_t step = scene.triangle_count / kOutlineTriangles + 1;
    std::size_t number = 0;
    for_each_triangle(scene, 1, [&](const Corners& triangle) {
        const double length = edges_of(triangle);
        all_edges += length;
        if (!lies_in(box, triangle)) return;
        edges += length;
        const bool is_sampled = number++ % step == 0;
        for (const glm::dvec3& p : triangle) {
            part.bounds.low = glm::min(part.bounds.low, p);
            part.bounds.high = glm::max(part.bounds.high, p);
            corners.include(p);
            if (is_sampled) others.include(p);
        }
    });
    part.outline = corners.points();
    part.outline.insert(part.outline.end(), others.points().begin(), others.points().end());
    return part;
}

}  // namespace

MainPart main_part(const Scene& scene) {
    double edges = 0, all_edges = 0;
    MainPart part = part_within(scene, fences(scene), edges, all_edges);
    if (edges >= kLeastPart * all_edges) return part;
    return part_within(scene, {glm::dvec3(-kInfinity), glm::dvec3(kInfinity)}, edges, all_edges);
}

}  // namespace aoscore
