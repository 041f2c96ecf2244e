#include "scene/builtin/shapes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace aoscore::builtin {

using glm::dvec2;
using glm::dvec3;

void append_arc(Profile& profile, const dvec2& centre, const dvec2& radii, double from_rad, double to_rad,
                int segments) {
    for (int i = 0; i <= segments; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / segments;
        const dvec2 point = centre + radii * dvec2(std::cos(angle), std::sin(angle));
        if (i == 0 && !profile.empty() && glm::length(profile.back() - point) < 1e-9) continue;
        profile.push_back(point);
    }
}

void add_box(MeshBuilder& mesh, const dvec3& low, const dvec3& high) {
    const auto corner = [&](int x, int y, int z) {
        return dvec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    mesh.quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    mesh.quad(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));
    mesh.quad(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));
    mesh.quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
    mesh.quad(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));
    mesh.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
}

void add_bevelled_box(MeshBuilder& mesh, const dvec3& low, const dvec3& high, double bevel_m) {
    const dvec3 centre = (low + high) / 2.0, half = (high - low) / 2.0;
    // The corner in octant s on the face of the given axis.
    const auto on_face = [&](const dvec3& s, int axis) {
        dvec3 p = half - dvec3(bevel_m);
        p[axis] = half[axis];
        return centre + s * p;
    };
    const auto add = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& outward) {
        if (glm::dot(glm::cross(b - a, c - a), outward) > 0) {
            mesh.triangle(a, b, c);
        } else {
            mesh.triangle(a, c, b);
        }
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            const auto octant = [&](double su, double sv) {
                dvec3 s(side);
                s[u] = su;
                s[v] = sv;
                return s;
            };
            dvec3 outward(0);
            outward[axis] = side;
            const dvec3 a = on_face(octant(-1, -1), axis), b = on_face(octant(1, -1), axis);
            const dvec3 c = on_face(octant(1, 1), axis), d = on_face(octant(-1, 1), axis);
            add(a, b, c, outward);
            add(a, c, d, outward);
            // The cut edges this face shares with the faces of axis u; each pair of axes comes once.
            for (const double su : {-1.0, 1.0}) {
                dvec3 edge_outward = outward;
                edge_outward[u] = su;
                const dvec3 e0 = on_face(octant(su, -1), axis), e1 = on_face(octant(su, 1), axis);
                const dvec3 f0 = on_face(octant(su, -1), u), f1 = on_face(octant(su, 1), u);
                add(e0, e1, f1, edge_outward);
                add(e0, f1, f0, edge_outward);
            }
        }
    }
    for (int octant = 0; octant < 8; ++octant) {
        const dvec3 s(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
        add(on_face(s, 0), on_face(s, 1), on_face(s, 2), s);
    }
}

void add_crates(MeshBuilder& mesh, int count) {
    constexpr double kBevel_m = 0.02;
    if (count > 0) add_bevelled_box(mesh, {-0.5, -0.05, -0.05}, {0.5, 0.84, 0.75}, kBevel_m);
    if (count > 1) add_bevelled_box(mesh, {-0.44, 0.8, -0.04}, {0.44, 1.5, 0.62}, kBevel_m);
    if (count > 2) add_bevelled_box(mesh, {-0.38, 1.45, -0.03}, {0.38, 2.0, 0.5}, kBevel_m);
}

void add_raised_block(MeshBuilder& mesh, const dvec3& low, const dvec3& high, double bevel_m) {
    const auto loop = [&](double inset, double z) {
        return std::array<dvec3, 4>{{{low.x + inset, low.y + inset, z},
                                     {high.x - inset, low.y + inset, z},
                                     {high.x - inset, high.y - inset, z},
                                     {low.x + inset, high.y - inset, z}}};
    };
    const auto foot = loop(0, low.z), shoulder = loop(0, high.z - bevel_m), top = loop(bevel_m, high.z);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t k = (i + 1) % 4;
        mesh.quad(foot[i], foot[k], shoulder[k], shoulder[i]);
        mesh.quad(shoulder[i], shoulder[k], top[k], top[i]);
    }
    mesh.quad(top[0], top[1], top[2], top[3]);
}

void add_surface(MeshBuilder& mesh, int columns, int rows, const std::function<dvec3(double, double)>& f,
                 bool wrap_u) {
    std::vector<dvec3> points;
    const int stride = columns + 1;
    points.reserve(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows + 1));
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const int wrapped = wrap_u && column == columns ? 0 : column;
            points.push_back(f(static_cast<double>(wrapped) / columns, static_cast<double>(row) / rows));
        }
    }
    const auto at = [&](int column, int row) {
        return points[static_cast<std::size_t>(row * stride + column)];
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            mesh.quad(at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1));
        }
    }
}

void add_lathe(MeshBuilder& mesh, const Profile& radius_and_y, int segments) {
    const int rows = static_cast<int>(radius_and_y.size()) - 1;
    add_surface(
        mesh, segments, rows,
        [&](double u, double v) {
            const dvec2 p = radius_and_y[static_cast<std::size_t>(std::lround(v * rows))];
            const double angle = 2 * std::numbers::pi * u;
            return dvec3(p.x * std::sin(angle), p.y, p.x * std::cos(angle));
        },
        true);
}

void add_part_lathe(MeshBuilder& mesh, const Profile& radius_and_y, int segments, double from_rad,
                    double to_rad) {
    const int rows = static_cast<int>(radius_and_y.size()) - 1;
    add_surface(mesh, segments, rows, [&](double u, double v) {
        const dvec2 p = radius_and_y[static_cast<std::size_t>(std::lround(v * rows))];
        const double angle = glm::mix(from_rad, to_rad, u);
        return dvec3(p.x * std::sin(angle), p.y, p.x * std::cos(angle));
    });
}

void add_frame(MeshBuilder& mesh, const Profile& offset_and_y, double half_x, double half_z) {
    const int rows = static_cast<int>(offset_and_y.size()) - 1;
    const std::array<dvec2, 4> sides{{{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}};  // counter-clockwise about +y
    add_surface(
        mesh, 4, rows,
        [&](double u, double v) {
            const dvec2 p = offset_and_y[static_cast<std::size_t>(std::lround(v * rows))];
            const dvec2 side = sides[static_cast<std::size_t>(std::lround(u * 4)) % 4];
            return dvec3(side.x * (half_x + p.x), p.y, side.y * (half_z + p.x));
        },
        true);
}

void add_run(MeshBuilder& mesh, const Profile& outline, double z0, double z1) {
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        const dvec2 a = outline[i], b = outline[i + 1];
        mesh.quad(dvec3(a, z1), dvec3(a, z0), dvec3(b, z0), dvec3(b, z1));
    }
}

void add_prism(MeshBuilder& mesh, const Profile& outline, double z0, double z1) {
    Profile closed = outline;
    closed.push_back(outline.front());
    add_run(mesh, closed, z0, z1);
    dvec2 mean(0);
    for (const dvec2& p : outline) mean += p / static_cast<double>(outline.size());
    for (std::size_t i = 0; i + 1 < closed.size(); ++i) {
        mesh.triangle(dvec3(mean, z1), dvec3(closed[i], z1), dvec3(closed[i + 1], z1));
        mesh.triangle(dvec3(mean, z0), dvec3(closed[i + 1], z0), dvec3(closed[i], z0));
    }
}

void add_torus(MeshBuilder& mesh, double major_m, double minor_m, int around, int across) {
    std::vector<dvec3> points;
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < across; ++k) {
            const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * k / across;
            const double r = major_m + minor_m * std::cos(b);
            points.emplace_back(r * std::cos(a), r * std::sin(a), minor_m * std::sin(b));
        }
    }
    const auto at = [&](int i, int k) {
        return points[static_cast<std::size_t>(i % around * across + k % across)];
    };
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < across; ++k) mesh.quad(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
    }
}

void add_sphere(MeshBuilder& mesh, const dvec3& centre, double radius_m, int levels) {
    constexpr double t = std::numbers::phi;
    const std::array<dvec3, 12> corners{{{-1, t, 0},
                                         {1, t, 0},
                                         {-1, -t, 0},
                                         {1, -t, 0},
                                         {0, -1, t},
                                         {0, 1, t},
                                         {0, -1, -t},
                                         {0, 1, -t},
                                         {t, 0, -1},
                                         {t, 0, 1},
                                         {-t, 0, -1},
                                         {-t, 0, 1}}};
    constexpr std::array<std::array<std::size_t, 3>, 20> kFaces{
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    const std::function<void(const dvec3&, const dvec3&, const dvec3&, int)> split =
        [&](const dvec3& a, const dvec3& b, const dvec3& c, int level) {
            if (level == 0) {
                mesh.triangle(centre + radius_m * a, centre + radius_m * b, centre + radius_m * c);
                return;
            }
            const dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
            split(a, ab, ca, level - 1);
            split(b, bc, ab, level - 1);
            split(c, ca, bc, level - 1);
            split(ab, bc, ca, level - 1);
        };
    for (const auto& [a, b, c] : kFaces) {
        split(glm::normalize(corners[a]), glm::normalize(corners[b]), glm::normalize(corners[c]), levels);
    }
}

}  // namespace aoscore::builtin
