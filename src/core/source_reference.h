#pragma once

#include "core/strict_json.h"

#include <string>

namespace aoscore {

/// Writes the source of a definition as one line. A source has either "author", "title" and "year", or
/// "repository" and "document"; in place of the year there may be a "version" where a page or a program has
/// no year, and "place" says more where it is known: "Intel, XeGTAO, 2021", "GameTechDev/XeGTAO, README.md,
/// commit a5b1686". Throws file_error for anything else.
std::string source_reference(StrictObject source);

}  // namespace aoscore
