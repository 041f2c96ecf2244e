#pragma once

#include <GL/glcorearb.h>

// The OpenGL 3.3 functions that this room calls, and no later one: a function that is not listed does not
// compile. Each is loaded from the context by its name; AOSCORE_GL_FUNCTIONS(X) calls X(upper-case name,
// name).
#define AOSCORE_GL_FUNCTIONS(X)                         \
    X(ACTIVETEXTURE, ActiveTexture)                     \
    X(ATTACHSHADER, AttachShader)                       \
    X(BEGINQUERY, BeginQuery)                           \
    X(BINDBUFFER, BindBuffer)                           \
    X(BINDFRAMEBUFFER, BindFramebuffer)                 \
    X(BINDTEXTURE, BindTexture)                         \
    X(BINDVERTEXARRAY, BindVertexArray)                 \
    X(BLENDEQUATION, BlendEquation)                     \
    X(BUFFERDATA, BufferData)                           \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)   \
    X(CLEARBUFFERFV, ClearBufferfv)                     \
    X(COLORMASK, ColorMask)                             \
    X(COMPILESHADER, CompileShader)                     \
    X(CREATEPROGRAM, CreateProgram)                     \
    X(CREATESHADER, CreateShader)                       \
    X(DELETEBUFFERS, DeleteBuffers)                     \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)           \
    X(DELETEPROGRAM, DeleteProgram)                     \
    X(DELETEQUERIES, DeleteQueries)                     \
    X(DELETESHADER, DeleteShader)                       \
    X(DELETETEXTURES, DeleteTextures)                   \
    X(DELETEVERTEXARRAYS, DeleteVertexArrays)           \
    X(DEPTHFUNC, DepthFunc)                             \
    X(DISABLE, Disable)                                 \
    X(DRAWARRAYS, DrawArrays)                           \
    X(DRAWBUFFERS, DrawBuffers)                         \
    X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)   \
    X(ENABLE, Enable)                                   \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
    X(ENDQUERY, EndQuery)                               \
    X(FINISH, Finish)                                   \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)       \
    X(FRAMEBUFFERTEXTURELAYER, FramebufferTextureLayer) \
    X(GENBUFFERS, GenBuffers)                           \
    X(GENFRAMEBUFFERS, GenFramebuffers)                 \
    X(GENQUERIES, GenQueries)                           \
    X(GENTEXTURES, GenTextures)                         \
    X(GENVERTEXARRAYS, GenVertexArrays)                 \
    X(GETACTIVEUNIFORM, GetActiveUniform)               \
    X(GETERROR, GetError)                               \
    X(GETINTEGERV, GetIntegerv)                         \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)             \
    X(GETPROGRAMIV, GetProgramiv)                       \
    X(GETQUERYOBJECTUI64V, GetQueryObjectui64v)         \
    X(GETSHADERINFOLOG, GetShaderInfoLog)               \
    X(GETSHADERIV, GetShaderiv)                         \
    X(GETSTRING, GetString)                             \
    X(GETTEXIMAGE, GetTexImage)                         \
    X(GETUNIFORMLOCATION, GetUniformLocation)           \
    X(LINKPROGRAM, LinkProgram)                         \
    X(PIXELSTOREI, PixelStorei)                         \
    X(SHADERSOURCE, ShaderSource)                       \
    X(TEXBUFFER, TexBuffer)                             \
    X(TEXIMAGE2D, TexImage2D)                           \
    X(TEXIMAGE3D, TexImage3D)                           \
    X(TEXPARAMETERI, TexParameteri)                     \
    X(TEXSUBIMAGE3D, TexSubImage3D)                     \
    X(UNIFORM1F, Uniform1f)                             \
    X(UNIFORM1I, Uniform1i)                             \
    X(UNIFORM1UI, Uniform1ui)                           \
    X(UNIFORM2F, Uniform2f)                             \
    X(UNIFORM2FV, Uniform2fv)                           \
    X(UNIFORM2I, Uniform2i)                             \
    X(UNIFORM3FV, Uniform3fv)                           \
    X(UNIFORM4FV, Uniform4fv)                           \
    X(UNIFORMMATRIX3FV, UniformMatrix3fv)               \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)               \
    X(USEPROGRAM, UseProgram)                           \
    X(VERTEXATTRIB1F, VertexAttrib1f)                   \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)         \
    X(VIEWPORT, Viewport)

namespace aoscore {
class GlContext;
}

namespace aoscore::gl {

#define AOSCORE_GL_DECLARE(UPPER, Name) extern PFNGL##UPPER##PROC Name;
AOSCORE_GL_FUNCTIONS(AOSCORE_GL_DECLARE)
#undef AOSCORE_GL_DECLARE

/// Fills the pointers above from this context, which must be current. Throws internal_error naming a missing
/// function.
void load_functions(const GlContext& context);

/// Throws internal_error when an OpenGL call since the last check failed, or the driver has lost the context;
/// `doing` names the action.
void check(const char* doing);

/// Whether check() has found the context of load_functions() lost: no call does anything in it any more.
bool context_lost();

}  // namespace aoscore::gl
