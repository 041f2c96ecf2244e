#include "scene/builtin/arches.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace aoscore::builtin {

using glm::dvec2;
using glm::dvec3;

namespace {

Profile mirrored(const Profile& right_half) {
    Profile arch = right_half;  // from the springing to the apex
    for (std::size_t i = right_half.size() - 1; i-- > 0;)
        arch.emplace_back(-right_half[i].x, right_half[i].y);
    return arch;
}

/// The point where the ray from (0,0) through p leaves the rectangle |x| <= half_width, y <= height.
dvec2 on_rectangle(const dvec2& p, double half_width, double height) {
    if (p.x == 0) return {0, height};
    if (std::abs(p.x) * height >= p.y * half_width) {
        return {std::copysign(half_width, p.x), p.y * half_width / std::abs(p.x)};
    }
    return {p.x * height / p.y, height};
}

/// Moves every point of an open line to its right by `offset`, mitred at the bends.
Profile offset_line(const Profile& line, double offset) {
    Profile moved;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const dvec2 before =
            glm::normalize(line[std::max<std::size_t>(i, 1)] - line[std::max<std::size_t>(i, 1) - 1]);
        const std::size_t last = line.size() - 2;
        const dvec2 after = glm::normalize(line[std::min(i, last) + 1] - line[std::min(i, last)]);
        const dvec2 n0(before.y, -before.x), n1(after.y, -after.x);
        moved.push_back(line[i] + (n0 + n1) * (offset / (1 + glm::dot(n0, n1))));
    }
    return moved;
}

}  // namespace

Profile semicircular_arch(double half_width_m, double rise_m, int segments) {
    Profile right;
    append_arc(right, {0, 0}, {half_width_m, rise_m}, 0, std::numbers::pi / 2, segments);
    right.front() = {half_width_m, 0};
    right.back() = {0, rise_m};
    return mirrored(right);
}

Profile pointed_arch(double half_width_m, double rise_m, int segments) {
    assert(rise_m > half_width_m);
    // The right arc's centre lies on the springing line, left of the middle.
    const double radius = (half_width_m * half_width_m + rise_m * rise_m) / (2 * half_width_m);
    const double apex_rad = std::atan2(rise_m, radius - half_width_m);
    Profile right;
    append_arc(right, {half_width_m - radius, 0}, {radius, radius}, 0, apex_rad, segments);
    right.front() = {half_width_m, 0};
    right.back() = {0, rise_m};
    return mirrored(right);
}

void add_arched_wall(MeshBuilder& mesh, const Profile& arch, double half_width_m, double height_m,
                     double half_thickness_m, Underside underside) {
    const double z = half_thickness_m;
    const auto both_faces = [&](const dvec2& a, const dvec2& b, const dvec2& c) {
        mesh.triangle(dvec3(a, z), dvec3(b, z), dvec3(c, z));
        mesh.triangle(dvec3(a, -z), dvec3(c, -z), dvec3(b, -z));
    };
    for (std::size_t i = 0; i + 1 < arch.size(); ++i) {
        const dvec2 a = arch[i], b = arch[i + 1];
        const dvec2 outer_a = on_rectangle(a, half_width_m, height_m);
        const dvec2 outer_b = on_rectangle(b, half_width_m, height_m);
        both_faces(a, outer_a, outer_b);
        both_faces(a, outer_b, b);
        if (outer_a.x != outer_b.x && outer_a.y != outer_b.y) {
            const dvec2 corner(outer_a.y < height_m ? half_width_m : -half_width_m, height_m);
            both_faces(outer_a, corner, outer_b);
        }
        mesh.quad(dvec3(a, z), dvec3(b, z), dvec3(b, -z), dvec3(a, -z));
    }
    if (underside == Underside::open) return;
    for (const double side : {-1.0, 1.0}) {
        const double inner = side > 0 ? arch.front().x : -half_width_m;
        const double outer = side > 0 ? half_width_m : arch.back().x;
        mesh.quad({inner, 0, -z}, {outer, 0, -z}, {outer, 0, z}, {inner, 0, z});
    }
}

Profile stilted(const Profile& arch, double jamb_m) {
    Profile raised{{arch.front().x, 0}};
    for (const dvec2& p : arch) raised.emplace_back(p.x, p.y + jamb_m);
    raised.emplace_back(arch.back().x, 0);
    return raised;
}

Profile widened(const Profile& arch, double half_width_m) {
    Profile wide = arch;
    for (dvec2& p : wide) p.x *= half_width_m / arch.front().x;
    return wide;
}

void add_window_wall(MeshBuilder& mesh, const Profile& opening, const WindowWall& wall) {
    MeshBuilder upper;
    add_arched_wall(upper, opening, wall.half_width_m, wall.high_m - wall.sill_m, wall.half_thickness_m,
                    Underside::open);
    glm::dmat4 up(1.0);
    up[3].y = wall.sill_m;
    mesh.append(upper, up);
    const double z = wall.half_thickness_m, low = wall.low_m, sill = wall.sill_m;
    const double x[4] = {-wall.half_width_m, opening.back().x, opening.front().x, wall.half_width_m};
    for (int i = 0; i < 3; ++i) {
        mesh.quad({x[i], low, z}, {x[i + 1], low, z}, {x[i + 1], sill, z}, {x[i], sill, z});
        mesh.quad({x[i + 1], low, -z}, {x[i], low, -z}, {x[i], sill, -z}, {x[i + 1], sill, -z});
    }
    mesh.quad({x[1], sill, z}, {x[2], sill, z}, {x[2], sill, -z}, {x[1], sill, -z});
}

void add_arch_moulding(MeshBuilder& mesh, const Profile& arch, const Profile& offset_and_z) {
    std::vector<Profile> lines;
    for (const dvec2& p : offset_and_z) lines.push_back(offset_line(arch, p.x));
    for (std::size_t k = 0; k < offset_and_z.size(); ++k) {
        const std::size_t next = (k + 1) % offset_and_z.size();
        const double z0 = offset_and_z[k].y, z1 = offset_and_z[next].y;
        for (std::size_t i = 0; i + 1 < arch.size(); ++i) {
            mesh.quad(dvec3(lines[k][i], z0), dvec3(lines[k][i + 1], z0), dvec3(lines[next][i + 1], z1),
                      dvec3(lines[next][i], z1));
        }
    }
}

void add_groin_vault(MeshBuilder& mesh, const Profile& along_x, const Profile& along_z, int rows) {
    // A web belongs to one barrel: its lines run from the groin, where that barrel's coordinate is as far out
    // as the other one's, to the edge of the bay. Both barrels take the groin's points from the same two
    // arches.
    assert(along_x.size() == along_z.size() &&
           along_x[along_x.size() / 2].y == along_z[along_z.size() / 2].y);
    const auto web = [&](const Profile& arch, const Profile& other, const auto& place) {
        const double edge = other.front().x;
        const auto point = [&](std::size_t column, int row) {
            const double groin = std::abs(other[column].x);
            const double along = row == rows ? edge : groin + (edge - groin) * row / rows;
            return place(arch[column].x, arch[column].y, along);
        };
        for (std::size_t column = 0; column + 1 < arch.size(); ++column) {
            for (int row = 0; row < rows; ++row) {
                mesh.quad(point(column, row), point(column + 1, row), point(column + 1, row + 1),
                          point(column, row + 1));
            }
        }
    };
    web(along_x, along_z, [](double x, double y, double z) { return dvec3(x, y, -z); });
    web(along_x, along_z, [](double x, double y, double z) { return dvec3(-x, y, z); });
    web(along_z, along_x, [](double z, double y, double x) { return dvec3(x, y, z); });
    web(along_z, along_x, [](double z, double y, double x) { return dvec3(-x, y, -z); });
}

}  // namespace aoscore::builtin
