#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace aoscore::builtin {
namespace {

using namespace atrium;

/// Placement of bay `i` of side `side` (0: +z, 1: +x, 2: -z, 3: -x): the part's x runs along the side, its +z
/// points out of the court, its origin is on the column axes' line in the middle of the bay.
glm::dmat4 bay(int side, int i) {
    const bool long_side = side % 2 == 0;
    const int count = long_side ? kBaysAlong : kBaysAcross;
    const double along = (i - (count - 1) / 2.0) * kBay_m;
    return quarter_turns_y(side) * translation(along, 0, long_side ? kHalfZ_m : kHalfX_m);
}

int bay_count(int side) {
    return side % 2 == 0 ? kBaysAlong : kBaysAcross;
}

void add_shell(SceneBuilder& scene, int stone, int plaster, int tiles) {
    MeshBuilder ground;
    add_box(ground, {-kHalfX_m - 0.2, -0.4, -kHalfZ_m - 0.2}, {kHalfX_m + 0.2, -0.02, kHalfZ_m + 0.2});
    scene.place(scene.mesh(ground, stone));

    // Offsets from the column axes outwards.
    const double wall = kWallHalf_m + kGallery_m;
    MeshBuilder rings;
    const auto ring = [&](Profile section) {
        section.push_back(section.front());
        add_frame(rings, section, kHalfX_m, kHalfZ_m);
    };
    ring({{wall + 0.2, -0.5}, {wall + 0.2, kStep_m}, {-0.58, kStep_m}, {-0.6, kStep_m - 0.02}, {-0.6, -0.5}});
    ring({{wall + 0.2, kUpperFloor_m - 0.4},
          {wall + 0.2, kUpperFloor_m},
          {-0.5, kUpperFloor_m},
          {-0.5, kUpperFloor_m - 0.06},
          {-0.46, kUpperFloor_m - 0.08},
          {-0.44, kUpperFloor_m - 0.15},
          {-0.38, kUpperFloor_m - 0.2},
          {-0.36, kUpperFloor_m - 0.28},
          {-0.28, kUpperFloor_m - 0.32},
          {-0.25, kUpperFloor_m - 0.4}});
    ring({{wall + 0.2, kCornice_m},
          {wall + 0.2, kCornice_m + 0.4},
          {-0.62, kCornice_m + 0.4},
          {-0.62, kCornice_m + 0.3},
          {-0.56, kCornice_m + 0.26},
          {-0.52, kCornice_m + 0.16},
          {-0.4, kCornice_m + 0.1},
          {-0.4, kCornice_m + 0.04},
          {-0.25, kCornice_m}});
    scene.place(scene.mesh(rings, stone));

    MeshBuilder walls;
    Profile section{{wall + kOuterWall_m, -0.5}, {wall + kOuterWall_m, kTop_m}, {wall, kTop_m}, {wall, -0.5}};
    section.push_back(section.front());
    add_frame(walls, section, kHalfX_m, kHalfZ_m);
    scene.place(scene.mesh(walls, plaster));

    MeshBuilder roof;
    Profile slope{{wall + 0.1, kTop_m - 0.4},
                  {wall + 0.1, kTop_m - 0.25},
                  {-0.75, kCornice_m + 0.6},
                  {-0.75, kCornice_m + 0.45},
                  {-0.55, kCornice_m + 0.35}};
    slope.push_back(slope.front());
    add_frame(roof, slope, kHalfX_m, kHalfZ_m);
    scene.place(scene.mesh(roof, tiles));
}

void add_arcades(SceneBuilder& scene, int stone, int plaster) {
    const int lower_columns = scene.mesh(lower_column(), stone),
              upper_columns = scene.mesh(upper_column(), stone);
    const int lower_arches = scene.mesh(lower_arch(), plaster),
              upper_arches = scene.mesh(upper_arch(), plaster);
    const int ribs = scene.mesh(gallery_rib(), plaster), vaults = scene.mesh(gallery_vault(), plaster);
    const int corner_vaults = scene.mesh(corner_vault(), plaster), piers = scene.mesh(corner_pier(), stone);
    const int pilasters = scene.mesh(pilaster(), stone), balustrades = scene.mesh(balustrade(), stone);
    const double middle = kWallHalf_m + kGallery_m / 2, wall = kWallHalf_m + kGallery_m;
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < bay_count(side); ++i) {
            const glm::dmat4 here = bay(side, i);
            scene.place(lower_arches, here * translation(0, kLowerSpringing_m, 0));
            scene.place(upper_arches, here * translation(0, kUpperSpringing_m, 0));
            scene.place(vaults, here * translation(0, kLowerSpringing_m, middle));
            scene.place(balustrades, here);
            const glm::dmat4 right = here * translation(kBay_m / 2, 0, 0);
            scene.place(ribs, right * translation(0, kLowerSpringing_m, middle) * quarter_turns_y(-1));
            scene.place(pilasters, right * translation(0, 0, wall) * quarter_turns_y(2));
            if (i + 1 < bay_count(side)) {
                scene.place(lower_columns, right);
                scene.place(upper_columns, right);
            } else {
                scene.place(piers, right);
                const double corner = (kWallHalf_m + kGallery_m + 0.25) / 2;
                scene.place(corner_vaults, right * translation(corner, kLowerSpringing_m, corner));
            }
        }
        const glm::dmat4 left = bay(side, 0) * translation(-kBay_m / 2, 0, 0);
        scene.place(ribs, left * translation(0, kLowerSpringing_m, middle) * quarter_turns_y(-1));
        scene.place(pilasters, left * translation(0, 0, wall) * quarter_turns_y(2));
    }
}

}  // namespace

Scene generate_atrium() {
    SceneBuilder scene;
    const int stone = scene.material("stone", glm::vec3(0.62f, 0.57f, 0.49f));
    const int plaster = scene.material("plaster", glm::vec3(0.74f, 0.68f, 0.58f));
    const int tiles = scene.material("roof tiles", glm::vec3(0.55f, 0.3f, 0.2f));
    add_shell(scene, stone, plaster, tiles);
    add_arcades(scene, stone, plaster);
    return scene.take();
}

}  // namespace aoscore::builtin
