#pragma once

#include <string>
#include <string_view>

namespace aoscore {

/// A text from outside (a file's name, a label, a message that quotes either) made fit to be shown on a
/// terminal, in a log, a page or an XML document, as one line: bytes that are no UTF-8, control characters,
/// line and paragraph separators, marks that change the direction of the text after them, and code points
/// that are no characters all become U+FFFD. The remaining text affects nothing around it.
std::string printable(std::string_view text);

/// The same for a text of several lines: line breaks and tabs stay.
std::string printable_lines(std::string_view text);

}  // namespace aoscore
