#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace aoscore::imported {

/// A scene as the importing program hands it over.
struct PlainScene {
    /// Textures, materials, meshes, instances, cameras and warnings, in the file's own units and axes.
    /// Normals may be of any length, and triangles without area.
    Scene scene;
    double metres_per_unit = 0;  ///< that the file states; 0: it states none
    bool states_axes = false;    ///< else y_up_from_file is the unit matrix
    glm::dmat3 y_up_from_file{
        1};               ///< turns the axes that the file states into x right, y up, z to the viewer
    std::string refusal;  ///< why the file cannot be read; then all else is empty
};

/// Writes the bytes that read_plain_scene() reads.
void write_plain_scene(const PlainScene& plain,
                       const std::function<void(const void* data, std::size_t size)>& write);

/// Reads it again, and trusts nothing of it: every count is bounded, memory grows only with the bytes that
/// arrive, all indices are in range and all numbers finite. `read` gives at most `size` bytes, and 0 at the
/// end. Nothing when the bytes end too early or are no such scene.
std::optional<PlainScene> read_plain_scene(
    const std::function<std::size_t(void* to, std::size_t size)>& read);

}  // namespace aoscore::imported
