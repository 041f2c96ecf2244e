#pragma once

#include "page/section.h"

#include <string>

namespace aoscore {

/// What the page's scripts know of the views, methods and images: the text of a script element of type
/// application/json. reports/README.md lists its members.
std::string stage_data(const PageSource& source);

/// The images themselves: script elements of a type that browsers leave alone, each with the name that
/// stage_data gives it as data-image.
std::string image_blocks(const PageSource& source);

}  // namespace aoscore
