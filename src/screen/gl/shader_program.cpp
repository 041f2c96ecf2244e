#include "screen/gl/shader_program.h"

#include "core/error.h"

#include <fmt/format.h>

#include <vector>

namespace aoscore {
namespace {

template <class Shader>
Shader compile(const std::string& name, const ShaderSource& source) {
    Shader shader = Shader::create();
    const GLchar* text = source.text().c_str();
    gl::ShaderSource(shader.name(), 1, &text, nullptr);
    gl::CompileShader(shader.name());
    GLint compiled = 0, length = 0;
    gl::GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    gl::GetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length) + 1, '\0');
    gl::GetShaderInfoLog(shader.name(), length, nullptr, log.data());
    throw internal_error("shader does not compile:\n" + source.explain(log.c_str()), name);
}

std::map<std::string, ShaderProgram::Uniform, std::less<>> active_uniforms(GLuint program) {
    std::map<std::string, ShaderProgram::Uniform, std::less<>> result;
    GLint count = 0, longest = 0;
    gl::GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    gl::GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::vector<GLchar> name(static_cast<std::size_t>(longest) + 1);
    for (GLint i = 0; i < count; ++i) {
        ShaderProgram::Uniform uniform;
        gl::GetActiveUniform(program, static_cast<GLuint>(i), longest, nullptr, &uniform.size, &uniform.type,
                             name.data());
        uniform.location = gl::GetUniformLocation(program, name.data());
        std::string key = name.data();
        if (const auto bracket = key.find('['); bracket != std::string::npos) key.resize(bracket);
        result.emplace(std::move(key), uniform);
    }
    return result;
}

}  // namespace

ShaderProgram::ShaderProgram(std::string name, const ShaderSource& vertex, const ShaderSource& fragment)
    : program_(gl::Program::create()) {
    const auto vertex_shader = compile<gl::VertexShader>(name, vertex);
    const auto fragment_shader = compile<gl::FragmentShader>(name, fragment);
    gl::AttachShader(program_.name(), vertex_shader.name());
    gl::AttachShader(program_.name(), fragment_shader.name());
    gl::LinkProgram(program_.name());
    GLint linked = 0, length = 0;
    gl::GetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        gl::GetProgramiv(program_.name(), GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length) + 1, '\0');
        gl::GetProgramInfoLog(program_.name(), length, nullptr, log.data());
        throw internal_error("shaders do not link:\n" + fragment.explain(log.c_str()), name);
    }
    uniforms_ = active_uniforms(program_.name());
    gl::check("compiling shaders");
}

GLint ShaderProgram::location(std::string_view uniform) const {
    const auto found = uniforms_.find(uniform);
    return found == uniforms_.end() ? -1 : found->second.location;
}

void ShaderProgram::use() const {
    gl::UseProgram(program_.name());
}

}  // namespace aoscore
