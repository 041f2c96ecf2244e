#pragma once

#include <cstddef>
#include <string_view>

namespace aoscore::importer {

/// How many nodes of an FBX file, text or binary, have a Visibility of zero: Assimp 5.2 passes over that
/// property.
std::size_t count_invisible_nodes(std::string_view content);

}  // namespace aoscore::importer
