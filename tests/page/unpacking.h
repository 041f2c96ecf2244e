#pragma once

#include <string>

namespace aoscore::testing {

/// The bytes of a page's text, read after the description in page/document/dense_text.h.
std::string bytes_of_dense_text(const std::string& text);

/// What the zlib stream in such a text holds. Fails the test where it does not end well.
std::string inflated(const std::string& text);

}  // namespace aoscore::testing
