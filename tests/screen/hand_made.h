#pragma once

#include "core/image.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <string>
#include <vector>

namespace aoscore::testing {

/// A scene without any mesh, with one opaque white material.
Scene empty_scene();

/// Adds the parallelogram origin + s a + t b, s and t in [0,1], with texture coordinates (s, t).
void add_quad(Scene& scene, const glm::dvec3& origin, const glm::dvec3& a, const glm::dvec3& b,
              int material = 0);

/// A square plane through `centre` with unit normal `normal`.
Scene plane_scene(const glm::dvec3& centre, const glm::dvec3& normal, double half_size);

/// Three mutually perpendicular quads and a box in front of them: contact, edges, a gap behind the box and
/// background.
Scene corner_scene();

/// A camera at the origin that looks down -z.
Camera front_camera();
/// A view of corner_scene() with background on the right.
Camera corner_camera();

/// Writes a picture for inspection; values from 0 to 1.
void write_png(const std::string& path, const ImageF& image);
/// Writes a picture of linear colours, in sRGB.
void write_png(const std::string& path, const Image<glm::vec3>& image);

/// The ids of the registry's methods, and gtest's name for such an id.
std::vector<std::string> method_ids();
std::string test_name(std::string id);

/// A complete request with a preset's filter.
MethodRequest request_for(const MethodDescriptor& method, const std::vector<MethodDescriptor>& filters,
                          const std::string& preset, const ParameterValues& overrides = {});

/// The presets that a renderer draws without a ray tracer.
std::vector<std::string> drawn_presets(const MethodDescriptor& method);

double mean_over(const ImageF& image, const Mask& mask);

}  // namespace aoscore::testing
