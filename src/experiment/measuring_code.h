#pragma once

#include <string_view>

namespace aoscore {

/// A digest of the sources that measurements are made by, taken when the program is built: a stored
/// measurement of other code is not used.
std::string_view measuring_code();

}  // namespace aoscore
