#pragma once

#include <string>
#include <string_view>

namespace aoscore {

/// Encodes the bytes as base64 with padding (RFC 4648, section 4), without line breaks.
std::string base64(std::string_view bytes);

}  // namespace aoscore
