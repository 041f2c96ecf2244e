#pragma once

#include "scene/builtin/mesh_builder.h"

/// The atrium's parts, each a mesh of its own, metres. Every number that two parts share stands here; lengths
/// along which parts meet are dyadic, so that placed neighbours share their seams to the last bit.
namespace aoscore::builtin::atrium {

inline constexpr double kBay_m = 2.75;                       ///< distance between column axes
inline constexpr int kBaysAlong = 8;                         ///< bays of the court's long sides (x)
inline constexpr int kBaysAcross = 3;                        ///< bays of its short sides (z)
inline constexpr double kHalfX_m = kBay_m * kBaysAlong / 2;  ///< half the court, to the column axes
inline constexpr double kHalfZ_m = kBay_m * kBaysAcross / 2;
inline constexpr double kWallHalf_m = 0.3125;  ///< half the arcade wall's thickness
inline constexpr double kGallery_m = 3.5;      ///< clear depth of the galleries
inline constexpr double kOuterWall_m = 0.5;

inline constexpr double kStep_m = 0.15;  ///< height of the galleries' floor above the court's
inline constexpr double kLowerSpringing_m = 3.75;
inline constexpr double kUpperFloor_m = 5.5;
inline constexpr double kParapet_m = 0.95;  ///< height above the upper floor
inline constexpr double kUpperSpringing_m = 8.25;
inline constexpr double kCornice_m = 10.25;  ///< underside of the roof's cornice
inline constexpr double kTop_m = 12;
inline constexpr double kVaultRise_m = 1.1;  ///< rise of the lower galleries' vaults above the springing

MeshBuilder lower_column();
MeshBuilder upper_column();
MeshBuilder corner_pier();
MeshBuilder lower_arch();
MeshBuilder upper_arch();
MeshBuilder gallery_rib();
MeshBuilder gallery_vault();
MeshBuilder corner_vault();
MeshBuilder pilaster();
MeshBuilder balustrade();
MeshBuilder pedestal();

MeshBuilder lion_head();
MeshBuilder medallion_frame();
MeshBuilder blind_panel();
MeshBuilder basin();

MeshBuilder curtain_rod();
MeshBuilder drawn_curtain();
MeshBuilder tied_curtain();
MeshBuilder banner();

Texture frond_texture();
MeshBuilder frond();
MeshBuilder planter();

MeshBuilder paving();
MeshBuilder door();
MeshBuilder beams();
MeshBuilder lamp();
MeshBuilder rosette();
MeshBuilder roof_tiles(double half_length_m);

}  // namespace aoscore::builtin::atrium
