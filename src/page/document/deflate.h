#pragma once

#include <string>
#include <string_view>

namespace aoscore {

/// Compresses the bytes to a zlib stream, which a page inflates with DecompressionStream. `level` is zlib's 0
/// to 9, `strategy` one of its Z_ constants. Throws internal_error where zlib fails.
std::string deflated(std::string_view bytes, int level, int strategy);

}  // namespace aoscore
