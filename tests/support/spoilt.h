#pragma once

#include <random>
#include <string>

namespace aoscore::testing {

/// A file's bytes, spoilt in a few of the ways in which files get spoilt: bits turned, parts lost, doubled or
/// cut off, numbers of a text replaced.
std::string spoilt(std::string bytes, std::mt19937& random);

}  // namespace aoscore::testing
