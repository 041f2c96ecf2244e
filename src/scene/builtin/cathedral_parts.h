#pragma once

#include "scene/builtin/arches.h"

/// The cathedral's parts, metres. x runs along the nave (east is +x), the origin lies on the nave's floor in
/// its middle. Shared numbers stand here; lengths along which parts meet are dyadic, so that seams agree to
/// the last bit.
namespace aoscore::builtin::cathedral {

inline constexpr double kBay_m = 5;
inline constexpr int kBays = 8;
inline constexpr double kHalfLength_m = kBay_m * kBays / 2;
inline constexpr double kArcade_m = 4;           ///< pier axes from the nave's middle
inline constexpr double kArcadeHalf_m = 0.4375;  ///< half the arcade wall's thickness
inline constexpr double kAisle_m = 4;            ///< clear width of an aisle
inline constexpr double kOuterHalf_m = 0.4;      ///< half the outer wall's thickness
inline constexpr double kOuterWall_m =
    kArcade_m + kArcadeHalf_m + kAisle_m + kOuterHalf_m;  ///< to the wall's middle

inline constexpr double kArcadeSpringing_m = 5;  ///< height of the springing of arcades and aisle vaults
inline constexpr double kAisleRise_m = 2.8;
inline constexpr double kString_m = 8.6;  ///< height of the string course above the arcade
inline constexpr double kNaveSpringing_m = 9;
inline constexpr double kNaveRise_m = 4.6;
inline constexpr double kWallTop_m = 14;
inline constexpr double kAisleTop_m = 8.3;
/// Vaults reach this far into the walls.
inline constexpr double kEmbed_m = 0.05;

/// Half widths of the vaults, across.
inline constexpr double kNaveVaultHalf_m = kArcade_m - kArcadeHalf_m + kEmbed_m;
inline constexpr double kAisleVaultHalf_m = kAisle_m / 2 + kEmbed_m;

MeshBuilder pier();
MeshBuilder vaulting_shafts();
MeshBuilder respond();

MeshBuilder arcade_arch();
MeshBuilder clerestory_bay();
MeshBuilder aisle_wall_bay();
MeshBuilder nave_vault_webs();
MeshBuilder nave_vault_ribs();
MeshBuilder aisle_vault_webs();
MeshBuilder aisle_vault_ribs();
MeshBuilder transverse_rib(double half_width_m, double rise_m, double half_thickness_m);

MeshBuilder apse_bay();
MeshBuilder apse_web();
MeshBuilder apse_rib();
MeshBuilder apse_roof();
MeshBuilder apse_shaft();
MeshBuilder choir_arch();
MeshBuilder rose_window();
MeshBuilder portal();

MeshBuilder paving();
MeshBuilder bench();
MeshBuilder altar();

}  // namespace aoscore::builtin::cathedral
