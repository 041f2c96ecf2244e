#pragma once

#include <random>
#include <string>

namespace aoscore::testing {

/// Damages a file's bytes in usual ways: flips bits, loses, doubles or cuts off parts, replaces numbers of a
/// text.
std::string spoilt(std::string bytes, std::mt19937& random);

}  // namespace aoscore::testing
