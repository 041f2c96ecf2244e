#include "screen/gbuffer/draw_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aoscore {
using Draw = SceneGeometry::Draw;

std::vector<Draw> from_the_nearest(const SceneGeometry& geometry, const CameraFrame& camera) {
    const glm::dmat4 view_from_scene = camera.view_from_world();
    std::vector<std::pair<double, Draw>> by_depth;
    for (const Draw& draw : geometry.draws()) {
        const glm::dvec4 centre(geometry.ranges()[static_cast<std::size_t>(draw.range)].centre, 1);
        by_depth.emplace_back(-(view_from_scene * (draw.scene_from_mesh * centre)).z, draw);
    }
    std::ranges::stable_sort(by_depth, {}, &std::pair<double, Draw>::first);
    std::vector<Draw> sorted;
    for (const auto& [depth, draw] : by_depth) sorted.push_back(draw);
    return sorted;
}

std::vector<std::vector<Draw>> parts_of(const SceneGeometry& geometry, std::span<const Draw> draws,
                                        std::span<const double> shares) {
    double triangles = 0;
    for (const Draw& draw : draws) triangles += draw.triangles;
    std::vector<std::vector<Draw>> parts(1);
    std::size_t share = 0;
    const auto room_for = [&] {
        const bool is_last = share + 1 >= shares.size();
        return is_last ? triangles : std::ceil(shares[share] * triangles);
    };
    double room = room_for();
    for (Draw draw : draws) {
        while (draw.triangles > room) {
            Draw fits = draw;
            fits.triangles = static_cast<GLsizei>(room);
            if (fits.triangles > 0) parts.back().push_back(fits);
            draw.first_triangle += fits.triangles;
            draw.triangles -= fits.triangles;
            parts.emplace_back();
            ++share;
            room = room_for();
        }
        room -= draw.triangles;
        parts.back().push_back(draw);
    }
    for (std::vector<Draw>& part : parts) {
        std::ranges::stable_partition(part, [&](const Draw& draw) {
            const int material = geometry.ranges()[static_cast<std::size_t>(draw.range)].material;
            return !geometry.materials()[static_cast<std::size_t>(material)].is_cutout();
        });
    }
    return parts;
}

}  // namespace aoscore
