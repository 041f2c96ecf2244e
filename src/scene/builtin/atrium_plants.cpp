#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Planters and the alpha-cut fronds that grow in them.
namespace aoscore::builtin::atrium {
namespace {

using glm::dvec2;
using glm::dvec3;

double distance_to_segment(const dvec2& p, const dvec2& a, const dvec2& b, double& along) {
    along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - glm::mix(a, b, along));
}

}  // namespace

/// A feathered leaf in the unit square, stem at the bottom: u across, v from tip (0) to foot (1), as glTF
/// counts. Alpha rises over one texel at the outline, so that the cut at 0.5 is smooth under bilinear
/// filtering.
Texture frond_texture() {
    constexpr int kWidth = 128, kHeight = 256;
    constexpr int kLeaflets = 11;
    Texture texture;
    texture.wrap_s = texture.wrap_t = Texture::Wrap::clamp_to_edge;
    texture.texels = Image<glm::u8vec4>(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            // In units of the frond's width: |x| <= 0.5, y from the foot 0 to the tip 2.
            const dvec2 p(std::abs((x + 0.5) / kWidth - 0.5), 2.0 - 2.0 * (y + 0.5) / kHeight);
            double along = 0;
            double inside = 0.018 * (1.2 - p.y / 2.2) - distance_to_segment(p, {0, 0}, {0, 1.9}, along);
            for (int i = 0; i < kLeaflets; ++i) {
                const double foot = 0.28 + 1.5 * i / (kLeaflets - 1.0);
                const double length = 0.5 * std::sin(std::numbers::pi * (0.2 + 0.72 * i / (kLeaflets - 1.0)));
                const dvec2 tip(length * 0.93, foot + 0.35 * length + 0.05);
                const double distance = distance_to_segment(p, {0, foot}, tip, along);
                const double width =
                    0.062 * std::sqrt(std::sin(std::numbers::pi * std::min(0.12 + along, 1.0)));
                inside = std::max(inside, width - distance);
            }
            const double alpha = std::clamp(0.5 + inside * kWidth, 0.0, 1.0);
            const double shade = 0.8 + 0.2 * std::sin(40 * p.y + 30 * p.x);
            texture.texels.at(x, y) =
                glm::u8vec4(static_cast<int>(70 * shade), static_cast<int>(120 * shade),
                            static_cast<int>(45 * shade), static_cast<int>(std::lround(255 * alpha)));
        }
    }
    return texture;
}

/// One frond of unit length: starts at the origin upwards, arches over towards +z, folded a little along its
/// rib.
MeshBuilder frond() {
    constexpr int kRows = 8;
    constexpr int kColumns = 2;
    const auto point = [](int column, int row) {
        const double t = static_cast<double>(row) / kRows,
                     side = static_cast<double>(column) / kColumns - 0.5;
        const double bend = 1.9 * t * t;  // the rib's direction turns from up to drooping
        const double z = 0.12 * t + 0.52 * t * t, y = t * std::cos(0.45 * bend) - 0.12 * t * t * t;
        return dvec3(side * 0.5, y + 0.1 * std::abs(side) * std::sin(bend), z - 0.25 * std::abs(side));
    };
    const auto uv = [](int column, int row) {
        return glm::vec2(static_cast<float>(column) / kColumns, 1.0f - static_cast<float>(row) / kRows);
    };
    MeshBuilder mesh;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            mesh.triangle(point(column, row), point(column + 1, row), point(column + 1, row + 1),
                          uv(column, row), uv(column + 1, row), uv(column + 1, row + 1));
            mesh.triangle(point(column, row), point(column + 1, row + 1), point(column, row + 1),
                          uv(column, row), uv(column + 1, row + 1), uv(column, row + 1));
        }
    }
    return mesh;
}

MeshBuilder planter() {
    const double half_pi = std::numbers::pi / 2;
    MeshBuilder mesh;
    add_bevelled_box(mesh, {-0.27, -0.05, -0.27}, {0.27, 0.1, 0.27}, 0.015);
    Profile line{{0.2, 0.08}};
    append_arc(line, {0.2, 0.125}, {0.04, 0.035}, -half_pi, half_pi, 4);
    line.insert(line.end(),
                {{0.15, 0.19}, {0.16, 0.23}, {0.25, 0.3}, {0.33, 0.42}, {0.35, 0.55}, {0.33, 0.66}});
    append_arc(line, {0.36, 0.71}, {0.05, 0.04}, -half_pi, half_pi, 5);
    line.insert(line.end(), {{0.33, 0.74}, {0.31, 0.68}, {0.15, 0.7}, {0, 0.71}});  // inside: earth
    add_lathe(mesh, line, 24);
    return mesh;
}

}  // namespace aoscore::builtin::atrium
