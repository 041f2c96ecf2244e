#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aoscore {

/// "1 view", "2 views": the number with the noun that it asks for.
inline std::string counted(std::size_t count, std::string_view one, std::string_view several) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : several);
}

}  // namespace aoscore
