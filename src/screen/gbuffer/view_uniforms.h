#pragma once

#include "scene/camera.h"

namespace aoscore {

class ShaderProgram;

/// The values of a camera for shaders/contract/view.glsl.
struct ViewUniforms {
    int width = 0, height = 0;  ///< u_size_px
    glm::dvec2 pixel_size{0};   ///< u_pixel_size: metres a pixel at depth 1 (orthographic: anywhere)
    double near = 0, far = 0;   ///< metres; far is rounded to float, since it marks the background
    bool orthographic = false;  ///< ORTHOGRAPHIC

    ViewUniforms() = default;
    explicit ViewUniforms(const CameraFrame& frame);

    /// Sets the uniforms of a program that is in use.
    void set(const ShaderProgram& program) const;
};

}  // namespace aoscore
