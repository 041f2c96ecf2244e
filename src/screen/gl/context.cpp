#include "screen/gl/context.h"

#include "screen/gl/gl.h"
#include "screen/gl/osmesa_context.h"

namespace aoscore {

std::unique_ptr<GlContext> new_gl_context() {
    auto context = std::make_unique<OsmesaContext>();
    gl::load_functions(*context);
    return context;
}

}  // namespace aoscore
