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

/// Draws a scene's triangles by shaders/gbuffer/scene.vert and a fragment shader of that folder, into
/// whatever is bound; keeps the programs. Row 0 of what it draws is the picture's top row.
class SceneDrawing {
  public:
    /// `fragment` is a file of shaders/gbuffer/; `name` is what errors call the programs.
    SceneDrawing(std::string name, std::string fragment)
        : name_(std::move(name)), fragment_(std::move(fragment)) {}

    struct Look {
        const SceneGeometry* geometry = nullptr;
        std::span<const SceneGeometry::Draw> draws;  ///< in the order of drawing
        const CameraFrame* frame = nullptr;
        std::string macros;  ///< of the shaders, beside ORTHOGRAPHIC and CUTOUT
        /// Window depth of the layer in front of what is to be drawn (macro PEELED); 0: none.
        GLuint layer_before = 0;
        /// Sets what the fragment shader has beside this, of a program that is in use. May be empty.
        std::function<void(const ShaderProgram&)> set_uniforms;
    };
    void draw(const Look& look);

  private:
    const ShaderProgram& program(const Look& look, bool orthographic, bool cutout);
    void begin(const Look& look, const ShaderProgram& program, const ViewUniforms& view) const;

    std::string name_, fragment_;
    std::map<std::string, ShaderProgram> programs_;  // by macros
};

}  // namespace aoscore
