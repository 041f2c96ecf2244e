#include "scene/builtin/generators.h"
#include "scene/scene.h"

namespace aoscore {

const std::vector<BuiltinScene>& builtin_scenes() {
    static const std::vector<BuiltinScene> scenes{
        {"atrium", "two-storey court: columns, arches, vaults, curtains, planters, a carved relief",
         builtin::generate_atrium},
        {"cathedral", "nave and aisles: clustered piers, pointed arches, ribbed vaults",
         builtin::generate_cathedral},
        {"pillar", "an occluder that hides behind a pillar (Vermeer 2020, section 4.5)",
         builtin::generate_pillar},
        {"plane", "closed form: a tilted plane, V = 1", builtin::generate_plane},
        {"wall", "closed form: floor and endless wall, 1 m high", builtin::generate_wall},
        {"wall_tall", "closed form: floor and endless wall, 8 m high, for cut-off radii",
         builtin::generate_wall_tall},
        {"sphere", "closed form: a sphere over a floor", builtin::generate_sphere},
        {"pit", "closed form: a circular pit, rim at zenith angle 40 degrees", builtin::generate_pit},
        {"railing", "thin bars before a wall: what a height field takes for solid",
         builtin::generate_railing},
        {"yard", "a pit, a wall, a box and a floating sphere: what the stress tests distort",
         builtin::generate_yard},
        {"layers", "occluders behind screens of 2 to 32 depth layers (Vermeer 2020, figure 9.7)",
         builtin::generate_layers},
        {"grazing", "a board and a wall that turn towards the line of sight (Vermeer 2020, figure 9.20)",
         builtin::generate_grazing},
        {"vault", "few triangles under smooth normals (Vermeer 2020, figures 4.6 and 4.9)",
         builtin::generate_vault},
        {"hairball", "a million thin triangles, many layers deep", builtin::generate_hairball},
        {"courtyard", "a court of trees, tables and arcades: many instances, foliage",
         builtin::generate_courtyard},
    };
    return scenes;
}

}  // namespace aoscore
