#pragma once

#include "scene/camera.h"
#include "screen/screen.h"

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// The files of a frame that was drawn without this program's scene.
struct FrameRequest {
    std::vector<std::filesystem::path> files;  ///< one, or one a picture
    std::string layout;                        ///< a row of frame_layouts(); empty: it is recognised
    std::filesystem::path camera;              ///< a camera file; empty: the header has it
};

/// A frame as the methods read it.
struct FrameFile {
    CameraFrame frame;
    GBufferImages images;  ///< depths, both normals, albedo where the frame has it; the surface's mask
    std::string read_as;   ///< where each picture was found, in words
    std::vector<std::string> warnings;
};

/// Reads a frame. Normals that it lacks are computed from its depth, and a single kind of normals stands for
/// both; `read_as` says so. Warns where normals do not fit the depth. Throws file_error where there is no
/// projection, and for depth that is NaN, of the wrong sign, or nowhere between near and far plane.
FrameFile read_frame(const FrameRequest& request);

}  // namespace aoscore
