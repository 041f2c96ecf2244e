#include "screen/gbuffer/farthest_samples.h"

#include "core/folders.h"
#include "screen/gl/texture.h"

#include <fmt/format.h>

namespace aoscore {

const ShaderProgram& FarthestSamples::program(int samples, bool orthographic) {
    const std::string macros =
        fmt::format("#define ORTHOGRAPHIC {}\n#define SAMPLES {}\n", orthographic ? 1 : 0, samples);
    if (const auto found = programs_.find(macros); found != programs_.end()) return found->second;
    const auto folder = data_dir() / "shaders" / "gbuffer";
    ShaderSource vertex, fragment;
    vertex.add_file(folder / "screen.vert", folder);
    fragment.add_block("(farthest sample's macros)", macros);
    fragment.add_file(folder / "farthest_sample.frag", folder);
    return programs_.emplace(macros, ShaderProgram("farthest sample", vertex, fragment)).first->second;
}

GLuint FarthestSamples::draw(GLuint array, int first_texture, int samples, const ViewUniforms& view) {
    if (view.width != width_ || view.height != height_) {
        depth_ = make_texture(kDepth32F, view.width, view.height);
        width_ = view.width;
        height_ = view.height;
    }
    if (!empty_vertices_) empty_vertices_ = gl::VertexArray::create();
    const gl::Framebuffer framebuffer = make_depth_framebuffer(depth_.name());
    const ShaderProgram& p = program(samples, view.orthographic);
    p.use();
    view.set(p);
    gl::Uniform1i(p.location("u_depth_layers"), 0);
    gl::Uniform1i(p.location("u_first_texture"), first_texture);
    gl::ActiveTexture(GL_TEXTURE0);
    gl::BindTexture(GL_TEXTURE_2D_ARRAY, array);
    gl::Viewport(0, 0, view.width, view.height);
    gl::Enable(GL_DEPTH_TEST);
    gl::DepthFunc(GL_ALWAYS);
    gl::BindVertexArray(empty_vertices_.name());
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    gl::Disable(GL_DEPTH_TEST);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    return depth_.name();
}

}  // namespace aoscore
