#pragma once

#include "scene/camera.h"

namespace aoscore {

class ShaderProgram;

/// What shaders/contract/view.glsl is given of a camera.
struct ViewUniforms {
    int width = 0, height = 0;  ///< u_size_px
    glm::dvec2 pixel_size{0};   ///< u_pixel_size: metres a pixel at depth 1 (orthographic: anywhere)
    double near = 0, far = 0;   ///< metres; far as a float has it, since it marks the background
    bool orthographic = false;  ///< ORTHOGRAPHIC

    ViewUniforms() = default;
    explicit ViewUniforms(const CameraFrame& frame);

    /// Of a program that is in use.
    void set(const ShaderProgram& program) const;
};

}  // namespace aoscore
