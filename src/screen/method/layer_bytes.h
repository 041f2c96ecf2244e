#pragma once

#include "screen/screen.h"

#include <cstddef>
#include <optional>

namespace aoscore {

/// The bytes of the depth layers that a request reads, of the view's camera and of side cameras, for a
/// picture of this size with the request's guard band; empty for a method without the inputs. What a pass
/// needs while it draws them, such as the two depth buffers of peeling, is not among them.
std::optional<std::size_t> layer_bytes(const MethodRequest& request, int width, int height);

}  // namespace aoscore
