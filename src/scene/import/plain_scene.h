#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace aoscore::imported {

/// A scene as aoscore-import passes it on.
struct PlainScene {
    /// Textures, materials, meshes, instances, cameras and warnings, in the file's own units and axes.
    /// Normals may be of any length, and triangles without area.
    Scene scene;
    double metres_per_unit = 0;  ///< the unit that the file states; 0 where it states none
    bool states_axes = false;    ///< where false, y_up_from_file is the unit matrix
    glm::dmat3 y_up_from_file{
        1};               ///< turns the axes that the file states into x right, y up, z to the viewer
    std::string refusal;  ///< the reason why the file cannot be read; all else is empty then
};

/// Writes the bytes that read_plain_scene() reads.
void write_plain_scene(const PlainScene& plain,
                       const std::function<void(const void* data, std::size_t size)>& write);

/// Reads those bytes, and trusts none of them: every count is bounded, memory grows only with the bytes that
/// arrive, all indices are in range and all numbers finite. `read` gives at most `size` bytes, and 0 at the
/// end. Returns nothing when the bytes end too early or are no such scene.
std::optional<PlainScene> read_plain_scene(
    const std::function<std::size_t(void* to, std::size_t size)>& read);

}  // namespace aoscore::imported
