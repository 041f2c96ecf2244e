#include "page/sections/listing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aoscore {
namespace {

/// The number of names in a sentence.
constexpr std::size_t kListed = 4;

}  // namespace

std::string listed(std::vector<std::string> names, const char* last_word) {
    if (names.size() > kListed + 1) {
        const std::size_t more = names.size() - kListed;
        names.resize(kListed);
        names.push_back(fmt::format("{} more", more));
    }
    if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
    const std::string last = names.back();
    names.pop_back();
    return fmt::format("{} {} {}", fmt::join(names, ", "), last_word, last);
}

}  // namespace aoscore
