#pragma once

#include "reference/truth.h"
#include "scene/camera.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace aoscore {

/// Writes a truth as EXR: what of truth_channels() it holds (of its first query), `V0.Y`, `V1.Y`, … and
/// `SE0.Y`, … the visibility of each query and its standard error, `mask.Y` 1 where `valid` says so; radii,
/// falloffs, samples and `attributes` in the header.
void write_truth(const std::filesystem::path& path, const Truth& truth, const Mask& valid,
                 std::map<std::string, std::string> attributes);

/// The attributes of a camera: `worldToCamera` and `worldToNDC` (OpenGL's clip space), the planes
/// `aoscore:near_m` and `aoscore:far_m`, `aoscore:projection`, and its angle or height. `origin` is the
/// offset of scene space (Scene::origin).
std::map<std::string, std::string> camera_attributes(const CameraFrame& frame, const glm::dvec3& origin);

/// The attributes of a G-buffer's file: those of its camera, the scene, the view's id, the renderer's name,
/// and `command`, which draws it again.
std::map<std::string, std::string> gbuffer_attributes(const Scene& scene, const std::string& view,
                                                      const CameraFrame& frame, const std::string& renderer,
                                                      const std::string& command);

/// View-space positions of the surfaces drawn, in metres; 0 where there is none.
Image<glm::vec3> view_positions(const GBufferImages& gbuffer, const CameraFrame& frame);

/// Writes a G-buffer as EXR: its channels by the names of image/channels.h, `P.X/Y/Z` view-space positions in
/// metres, `mask.Y`, `Y` equal to Z for viewers, and the surfaces behind one another, where there are some,
/// by the names of image/surface_channels.h. Channels that were not drawn are left out.
void write_gbuffer(const std::filesystem::path& path, const GBufferImages& gbuffer,
                   const Image<glm::vec3>& positions_m, const std::map<std::string, std::string>& attributes,
                   std::span<const SurfaceLayer> surfaces = {});

}  // namespace aoscore
