#include "screen/gbuffer/side_cameras.h"

#include "core/error.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/shader_program.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

/// The offset of a side camera in the picture's plane, metres to the right and up.
glm::dvec2 offset_of(int index, const SideLayers& side, Mirror mirror) {
    const double turn = 2 * std::numbers::pi * index / side.cameras;
    glm::dvec2 offset{side.right_m, 0};
    if (index > 0) offset = side.right_m * glm::dvec2(std::cos(turn), std::sin(turn));
    if (mirror == Mirror::left_right) offset.x = -offset.x;
    if (mirror == Mirror::up_down) offset.y = -offset.y;
    return offset;
}

double aim_of(const Camera& main, const SideLayers& side) {
    const double aim_m = side.aim_m > 0 ? side.aim_m : (main.near + main.far) / 2;
    if (aim_m <= side.ahead_m) {
        throw usage_error(
            fmt::format("side cameras {:g} m ahead of the view's look at a point {:g} m ahead of "
                        "it, which is not in front of them",
                        side.ahead_m, aim_m),
            "side cameras", "a point to look at that lies farther ahead than they stand");
    }
    return aim_m;
}

Camera placed(const CameraFrame& main, const glm::dvec2& offset, const SideLayers& side) {
    const glm::dmat3 axes(main.world_from_view());
    const glm::dvec3 forward = -axes[2];
    Camera camera = main.camera();
    if (offset != glm::dvec2(0)) {
        camera.up = axes[1];
        camera.target = main.camera().position + forward * aim_of(main.camera(), side);
        camera.position += axes[0] * offset.x + axes[1] * offset.y + forward * side.ahead_m;
    } else {
        camera.position += forward * side.ahead_m;
        camera.target += forward * side.ahead_m;
    }
    return camera;
}

}  // namespace

std::vector<CameraFrame> side_cameras(const CameraFrame& main, const SideLayers& side, Mirror mirror) {
    const auto scaled = [&](int size) { return (size + side.scale - 1) / side.scale; };
    std::vector<CameraFrame> cameras;
    for (int i = 0; i < side.cameras; ++i) {
        cameras.emplace_back(placed(main, offset_of(i, side, mirror), side), scaled(main.width()),
                             scaled(main.height()));
    }
    return cameras;
}

void set_side_uniforms(const ShaderProgram& program, const CameraFrame& main,
                       const std::vector<CameraFrame>& cameras) {
    const ViewUniforms view(cameras.front());
    gl::Uniform2f(program.location("u_side_size_px"), static_cast<float>(view.width),
                  static_cast<float>(view.height));
    gl::Uniform2f(program.location("u_side_pixel_size"), static_cast<float>(view.pixel_size.x),
                  static_cast<float>(view.pixel_size.y));
    // The compiler may have shortened the array to the elements in use.
    const auto array = program.uniforms().find("u_side_from_view");
    if (array == program.uniforms().end()) return;
    for (std::size_t i = 0; i < cameras.size() && static_cast<GLint>(i) < array->second.size; ++i) {
        const glm::mat4 side_from_view(cameras[i].view_from_world() * main.world_from_view());
        gl::UniformMatrix4fv(array->second.location + static_cast<GLint>(i), 1, GL_FALSE,
                             glm::value_ptr(side_from_view));
    }
}

}  // namespace aoscore
