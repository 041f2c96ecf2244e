#pragma once

#include "screen/gl/gl.h"

#include <utility>

namespace aoscore::gl {

/// An OpenGL object's name, created and deleted by the functions of `Kind`; movable, not copyable.
template <class Kind>
class Object {
  public:
    Object() = default;
    ~Object() { reset(); }
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }

    static Object create() {
        Object object;
        object.name_ = Kind::create();
        return object;
    }
    explicit operator bool() const { return name_ != 0; }
    GLuint name() const { return name_; }

  private:
    void reset() {
        if (name_ != 0) Kind::destroy(name_);
        name_ = 0;
    }
    GLuint name_ = 0;
};

#define AOSCORE_GL_KIND(Name)                                           \
    struct Name##Kind {                                                 \
        static GLuint create() {                                        \
            GLuint name = 0;                                            \
            Gen##Name##s(1, &name);                                     \
            return name;                                                \
        }                                                               \
        static void destroy(GLuint name) { Delete##Name##s(1, &name); } \
    };                                                                  \
    using Name = Object<Name##Kind>;
AOSCORE_GL_KIND(Texture)
AOSCORE_GL_KIND(Buffer)
AOSCORE_GL_KIND(Framebuffer)
AOSCORE_GL_KIND(VertexArray)
#undef AOSCORE_GL_KIND

struct ProgramKind {
    static GLuint create() { return CreateProgram(); }
    static void destroy(GLuint name) { DeleteProgram(name); }
};
using Program = Object<ProgramKind>;

template <GLenum stage>
struct ShaderKind {
    static GLuint create() { return CreateShader(stage); }
    static void destroy(GLuint name) { DeleteShader(name); }
};
using VertexShader = Object<ShaderKind<GL_VERTEX_SHADER>>;
using FragmentShader = Object<ShaderKind<GL_FRAGMENT_SHADER>>;

}  // namespace aoscore::gl
