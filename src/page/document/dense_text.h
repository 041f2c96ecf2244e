#pragma once

#include <string>
#include <string_view>

namespace aoscore {

/// Writes bytes as printable ASCII for a script element: 1.23 characters a byte, where base64 takes 1.33. Bits
/// are taken from the lowest one of the first byte on, thirteen for two characters: the first character's
/// digit times 93 plus the second's. Digits are the characters from '!' to '~' without '<', in their order. Of
/// the bits that are left over at the end up to six take one character.
std::string dense_text(std::string_view bytes);

}  // namespace aoscore
