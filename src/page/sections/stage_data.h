#pragma once

#include "page/section.h"

#include <string>

namespace aoscore {

/// The data of views, methods and images for the page's scripts: the text of a script element of type
/// application/json. reports/README.md lists its members.
std::string stage_data(const PageSource& source);

/// The images themselves: script elements of a type that browsers do not run, each with its name in
/// stage_data() as data-image.
std::string image_blocks(const PageSource& source);

}  // namespace aoscore
