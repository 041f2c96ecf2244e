#pragma once

#include "image/frame_layout.h"
#include "jobs/recorded/frame_camera.h"
#include "screen/screen.h"

#include <string>

namespace aoscore {

/// Depth of a frame in metres, and where it shows a surface.
struct FrameDepth {
    CameraFrame frame;  ///< its planes were chosen around the depths where none were stated
    ImageF view_depth;  ///< metres, positive; the far plane's (as float32) on background
    ImageF window_depth;
    Mask surface;
};

/// Turns stored depth into view depth. `where` names the file and channel. Throws file_error for NaN, for
/// depth of the wrong sign, where no surface lies between the near and far plane, and for a depth buffer
/// whose planes are unknown.
FrameDepth frame_depth(const ImageF& stored, DepthKind kind, double background_from,
                       const FrameCamera& camera, const std::string& where);

}  // namespace aoscore
