#pragma once

#include "image/frame_layout.h"
#include "scene/camera.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace aoscore {

/// What a frame's pictures do not say themselves: the projection, and how to read depth and normals.
struct FrameCamera {
    Camera camera;                              ///< at the origin, looking down -z
    bool has_planes = true;                     ///< whether near and far were stated
    bool infinite_far = false;                  ///< whether its depth buffer has no far plane
    std::optional<DepthKind> depth;             ///< empty: as the layout has it
    double metres_per_unit = 1;                 ///< of depths
    std::optional<bool> world_normals;          ///< empty: as the layout has it
    glm::dvec3 normal_signs{1, 1, 1};           ///< times the components of the file's normals
    std::optional<glm::dmat3> view_from_world;  ///< the camera's rotation; empty: not stated
};

/// Reads a camera file (see reports/README.md) for pictures of this aspect. Throws file_error.
FrameCamera read_frame_camera(const std::filesystem::path& json, double aspect);

/// The camera that `aoscore gbuffer` wrote into a file's header; empty where it did not write the file.
/// Throws file_error for one that is incomplete; `where` names the file.
std::optional<FrameCamera> frame_camera_of_header(const std::map<std::string, std::string>& attributes,
                                                  const std::string& where);

}  // namespace aoscore
