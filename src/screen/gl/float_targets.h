#pragma once

namespace aoscore {

/// Draws into textures of every format that the passes draw into, one pixel each, and reads them back. Throws
/// internal_error, which names the driver and the format, where the driver cannot draw into one or keeps fewer
/// than 32 bits of a float: pictures of such a driver would differ from those of every other one. The context
/// must be current, and its functions loaded.
void require_float_targets();

}  // namespace aoscore
