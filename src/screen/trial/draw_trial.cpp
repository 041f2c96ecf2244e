#include "screen/trial/draw_trial.h"

#include "screen/gl/context.h"
#include "screen/gl/gl_objects.h"
#include "screen/gl/texture.h"

namespace aoscore {
namespace {

constexpr int kSize = 8;

void attach(const gl::Program& program, GLuint shader, const std::string& text) {
    const GLchar* source = text.c_str();
    gl::ShaderSource(shader, 1, &source, nullptr);
    gl::CompileShader(shader);
    gl::AttachShader(program.name(), shader);
}

bool links(const gl::Program& program) {
    gl::LinkProgram(program.name());
    GLint linked = 0;
    gl::GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    return linked == GL_TRUE;
}

}  // namespace

void draw_trial(const std::string& vertex, const std::string& fragment) {
    const std::unique_ptr<GlContext> context = new_gl_context();
    const gl::Program program = gl::Program::create();
    const gl::VertexShader vertex_shader = gl::VertexShader::create();
    const gl::FragmentShader fragment_shader = gl::FragmentShader::create();
    attach(program, vertex_shader.name(), vertex);
    attach(program, fragment_shader.name(), fragment);
    if (!links(program)) return;
    const gl::Texture first = make_texture(kR32F, kSize, kSize), second = make_texture(kR32F, kSize, kSize);
    const gl::Framebuffer framebuffer = make_framebuffer({first.name(), second.name()});
    const gl::VertexArray no_vertices = gl::VertexArray::create();
    gl::Viewport(0, 0, kSize, kSize);
    gl::UseProgram(program.name());
    gl::Uniform2f(gl::GetUniformLocation(program.name(), "u_size_px"), kSize, kSize);
    gl::Uniform2f(gl::GetUniformLocation(program.name(), "u_pixel_size"), 1.0F / kSize, 1.0F / kSize);
    gl::Uniform1f(gl::GetUniformLocation(program.name(), "u_far"), 1);
    gl::BindVertexArray(no_vertices.name());
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    gl::Finish();
    gl::check("trying a shader");
}

}  // namespace aoscore
