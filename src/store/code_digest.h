#pragma once

#include <string_view>

namespace aoscore {

/// The digest of the sources that make a kind of artifact: "truth", "image", … It covers the link closure of
/// the function that makes the artifact: every source whose object the linker takes for it, with the headers
/// that these include. It is computed by the build (src/CMakeLists.txt lists the kinds), so that an artifact
/// of other code is never used and an edit elsewhere costs nothing. Throws internal_error for an unknown
/// kind.
std::string_view code_digest(std::string_view kind);

}  // namespace aoscore
