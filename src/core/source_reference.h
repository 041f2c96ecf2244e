#pragma once

#include "core/strict_json.h"

#include <string>

namespace aoscore {

/// A definition's source as one line, "author, title, year" and the place in it where one is given. `source`
/// holds author, title, year and optionally place. Throws file_error for anything else.
std::string source_reference(StrictObject source);

}  // namespace aoscore
