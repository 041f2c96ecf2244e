#pragma once

#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// The text with every byte but letters, digits and -._~/, in percent encoding (RFC 3986), as a link needs
/// it.
std::string percent_encoded(const std::string& text);

/// The address within the page, "#view=…&cell=…", at which the stage shows what the entries name; their
/// values are percent-encoded (RFC 3986). reports/page/scripts/address.js reads it.
std::string stage_link(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace aoscore
