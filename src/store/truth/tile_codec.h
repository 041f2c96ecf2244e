#pragma once

#include "reference/integrator/tile_store.h"

#include <string>
#include <string_view>

namespace aoscore {

/// Turn a group's tiles into bytes, without loss, and back. decode() throws file_error naming `where` for
/// bytes that encode() cannot have made.
std::string encode(const GroupState& state);
GroupState decode(std::string_view bytes, const std::string& where);

}  // namespace aoscore
