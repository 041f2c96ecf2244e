#pragma once

#include <string>
#include <vector>

namespace aoscore {

/// One line of comma-separated values with its line end, fields quoted where they must be (RFC 4180). A field
/// that a spreadsheet would take for a formula begins with an apostrophe.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace aoscore
