#include "screen/gbuffer/view_uniforms.h"

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

}  // namespace aoscore
