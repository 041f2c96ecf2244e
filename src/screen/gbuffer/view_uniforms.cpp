#include "screen/gbuffer/view_uniforms.h"

#include "screen/gl/shader_program.h"

namespace aoscore {

ViewUniforms::ViewUniforms(const CameraFrame& frame)
    : width(frame.width()),
      height(frame.height()),
      near(frame.camera().near),
      far(static_cast<float>(frame.camera().far)),
      orthographic(frame.camera().projection == Camera::Projection::orthographic) {
    const glm::dvec3 span = frame.view_position(1, 1, 1) - frame.view_position(0, 0, 1);
    pixel_size = {span.x, -span.y};
}

void ViewUniforms::set(const ShaderProgram& program) const {
    gl::Uniform2f(program.location("u_size_px"), static_cast<float>(width), static_cast<float>(height));
    gl::Uniform2f(program.location("u_pixel_size"), static_cast<float>(pixel_size.x),
                  static_cast<float>(pixel_size.y));
    gl::Uniform1f(program.location("u_near"), static_cast<float>(near));
    gl::Uniform1f(program.location("u_far"), static_cast<float>(far));
}

}  // namespace aoscore
