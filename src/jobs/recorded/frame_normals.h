#pragma once

#include "image/frame_layout.h"
#include "jobs/recorded/frame_camera.h"
#include "jobs/recorded/frame_depth.h"
#include "screen/screen.h"

#include <string>
#include <vector>

namespace aoscore {

/// Adds both kinds of normals to a frame's images, and to `read_as` where they come from: from the file, or,
/// where it has none, from `from_depth`. Normals of a file are brought into view space and turned to the
/// side of those. Throws file_error for NaN on surfaces, and where world space cannot be turned into the
/// camera's; `where` names the file.
void add_normals(const ImageFile& file, const FrameLayout& layout, const FrameCamera& camera,
                 const Image<glm::vec3>& from_depth, const std::string& where, GBufferImages& images,
                 std::string& read_as, std::vector<std::string>& warnings);

}  // namespace aoscore
