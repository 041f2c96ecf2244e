#pragma once

#include "scene/scene.h"

/// One function a built-in scene; all are deterministic. load_scene() adds views, bounds, counts and digest.
namespace aoscore::builtin {

Scene generate_atrium();
Scene generate_cathedral();
Scene generate_pillar();
Scene generate_plane();
Scene generate_wall();
Scene generate_wall_tall();
Scene generate_sphere();
Scene generate_pit();
Scene generate_railing();
Scene generate_yard();
Scene generate_layers();
Scene generate_grazing();
Scene generate_vault();
Scene generate_hairball();
Scene generate_courtyard();

}  // namespace aoscore::builtin
