#pragma once

#include <string>
#include <vector>

namespace aoscore {

/// Joins names for a sentence: "A, B and C"; of more than five names the first four "and 3 more", because a
/// table has all of them.
std::string listed(std::vector<std::string> names, const char* last_word = "and");

}  // namespace aoscore
