#pragma once

#include "scene/camera.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/shader_program.h"

#include <functional>
#include <map>
#include <span>
#include <string>

namespace aoscore {

/// Draws a scene's triangles by shaders/gbuffer/scene.vert and a fragment shader of that folder, into the
/// bound framebuffer; keeps the programs. Row 0 of the result is the picture's top row.
class SceneDrawing {
  public:
    /// `fragment` is a file of shaders/gbuffer/; errors call the programs `name`.
    SceneDrawing(std::string name, std::string fragment)
        : name_(std::move(name)), fragment_(std::move(fragment)) {}

    struct Look {
        const SceneGeometry* geometry = nullptr;
        std::span<const SceneGeometry::Draw> draws;  ///< in the order of drawing
        const CameraFrame* frame = nullptr;
        std::string macros;  ///< macros of the shaders beside ORTHOGRAPHIC and CUTOUT
        /// The window depth of the layer in front of the one to draw (macro PEELED); 0: none.
        GLuint layer_before = 0;
        /// Sets further uniforms of the fragment shader, whose program is in use. It may be empty.
        std::function<void(const ShaderProgram&)> set_uniforms;
    };
    void draw(const Look& look);

  private:
    const ShaderProgram& program(const Look& look, bool orthographic, bool cutout);
    void begin(const Look& look, const ShaderProgram& program, const ViewUniforms& view) const;

    std::string name_, fragment_;
    std::map<std::string, ShaderProgram> programs_;  // indexed by macros
};

}  // namespace aoscore
