#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <string_view>

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
    ring({{wall + 0.2, -0.45},
          {wall + 0.2, kStep_m},
          {-0.58, kStep_m},
          {-0.6, kStep_m - 0.02},
          {-0.6, -0.45}});
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
    const int long_slopes = scene.mesh(roof_tiles(kHalfX_m), tiles),
              short_slopes = scene.mesh(roof_tiles(kHalfZ_m), tiles);
    for (int side = 0; side < 4; ++side) {
        const bool long_side = side % 2 == 0;
        scene.place(long_side ? long_slopes : short_slopes,
                    quarter_turns_y(side) * translation(0, 0, long_side ? kHalfZ_m : kHalfX_m));
    }
}

void add_arcades(SceneBuilder& scene, int stone, int plaster) {
    const int lower_columns = scene.mesh(lower_column(), stone),
              upper_columns = scene.mesh(upper_column(), stone);
    const int lower_arches = scene.mesh(lower_arch(), plaster),
              upper_arches = scene.mesh(upper_arch(), plaster);
    const int ribs = scene.mesh(gallery_rib(), plaster), vaults = scene.mesh(gallery_vault(), plaster);
    const int corner_vaults = scene.mesh(corner_vault(), plaster), piers = scene.mesh(corner_pier(), stone);
    const int pilasters = scene.mesh(pilaster(), stone), balustrades = scene.mesh(balustrade(), stone);
    const int pedestals = scene.mesh(pedestal(), stone);
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
                scene.place(pedestals, right);
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

/// Adds the fittings of every bay: lamps, beams, rosettes, doors behind.
void add_fittings(SceneBuilder& scene, int stone, int wood, int bronze) {
    const int lamps = scene.mesh(lamp(), bronze), ceilings = scene.mesh(beams(), wood);
    const int rosettes = scene.mesh(rosette(), stone), doors = scene.mesh(door(), wood);
    const double middle = kWallHalf_m + kGallery_m / 2, wall = kWallHalf_m + kGallery_m;
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < bay_count(side); ++i) {
            const glm::dmat4 here = bay(side, i);
            scene.place(ceilings, here);
            scene.place(lamps, here * translation(0, kLowerSpringing_m + kVaultRise_m, middle));
            if (i % 2 == 1) scene.place(doors, here * translation(0, 0, wall) * quarter_turns_y(2));
            if (i % 2 == 0) {
                scene.place(doors, here * translation(0, kUpperFloor_m - kStep_m, wall) * quarter_turns_y(2));
            }
            if (i + 1 == bay_count(side)) continue;
            scene.place(rosettes, here * translation(kBay_m / 2, kLowerSpringing_m + 0.95, -kWallHalf_m) *
                                      quarter_turns_y(2));
        }
    }
    scene.place(scene.mesh(paving(), stone));
}

/// Adds the lion and its fountain, which close the middle arch of the court's far end (+x).
void add_relief(SceneBuilder& scene, int stone, int plaster) {
    const glm::dmat4 here = bay(1, kBaysAcross / 2);
    scene.place(scene.mesh(blind_panel(), plaster), here);
    const glm::dmat4 face = here * quarter_turns_y(2) * translation(0, 2.6, 0.12);
    scene.place(scene.mesh(lion_head(), stone), face);
    scene.place(scene.mesh(medallion_frame(), stone), face);
    scene.place(scene.mesh(basin(), stone), here * quarter_turns_y(2) * translation(0, 0, 0.1));
}

void add_cloth(SceneBuilder& scene, int cloth, int bronze) {
    const int rods = scene.mesh(curtain_rod(), bronze), drawn = scene.mesh(drawn_curtain(), cloth);
    const int tied = scene.mesh(tied_curtain(), cloth), banners = scene.mesh(banner(), cloth);
    // A letter a bay of the two long sides: drawn, tied to the left or right, a banner above, nothing.
    constexpr std::string_view kPlan[2] = {".lrbdlrb", "d.blrbl."};
    for (const int side : {0, 2}) {
        for (int i = 0; i < kBaysAlong; ++i) {
            const glm::dmat4 here = bay(side, i);
            const char what = kPlan[static_cast<std::size_t>(side / 2)][static_cast<std::size_t>(i)];
            if (what == 'b') scene.place(banners, here);
            if (what == 'd' || what == 'l' || what == 'r') scene.place(rods, here);
            if (what == 'd') scene.place(drawn, here);
            if (what == 'l') scene.place(tied, here);
            if (what == 'r') scene.place(tied, here * quarter_turns_y(2));
        }
    }
}

void add_planters(SceneBuilder& scene, int stone) {
    const int leaf = scene.cutout_material("fronds", frond_texture(), 0.5f);
    const int pots = scene.mesh(planter(), stone), fronds = scene.mesh(frond(), leaf);
    constexpr int kFronds = 22;
    std::uint32_t grown = 0;
    for (const int side : {0, 2}) {
        for (int i = 0; i < kBaysAlong; i += 2) {
            const glm::dmat4 foot = bay(side, i) * translation(kBay_m / 2, 0, -1.1);
            scene.place(pots, foot);
            for (int k = 0; k < kFronds; ++k, ++grown) {
                const double turn = 2.399963 * k + 0.5 * hash_unit(11, grown);  // the golden angle
                const double lean = 0.1 + 0.75 * (k + hash_unit(12, grown)) / kFronds;
                const double size = 0.75 + 0.4 * hash_unit(13, grown);
                scene.place(fronds, foot * translation(0, 0.69, 0) * rotation_y(turn) *
                                        translation(0, 0, 0.04) * rotation_x(lean) *
                                        scaling(size, size, size));
            }
        }
    }
}

}  // namespace

Scene generate_atrium() {
    SceneBuilder scene;
    const int stone = scene.material("stone", glm::vec3(0.62f, 0.57f, 0.49f));
    const int plaster = scene.material("plaster", glm::vec3(0.74f, 0.68f, 0.58f));
    const int tiles = scene.material("roof tiles", glm::vec3(0.55f, 0.3f, 0.2f));
    const int wood = scene.material("wood", glm::vec3(0.36f, 0.24f, 0.15f));
    const int bronze = scene.material("bronze", glm::vec3(0.3f, 0.24f, 0.14f));
    const int cloth = scene.material("cloth", glm::vec3(0.5f, 0.12f, 0.1f));
    add_shell(scene, stone, plaster, tiles);
    add_arcades(scene, stone, plaster);
    add_fittings(scene, stone, wood, bronze);
    add_relief(scene, stone, plaster);
    add_cloth(scene, cloth, bronze);
    add_planters(scene, stone);
    return scene.take();
}

}  // namespace aoscore::builtin
