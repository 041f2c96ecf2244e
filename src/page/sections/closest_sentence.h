#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace aoscore {

/// What a ranking says of its first methods.
struct ClosestMethods {
    std::vector<std::string> leaders;  ///< those that may be the closest, each with its value where several
    std::size_t ranked = 0;            ///< methods, the leaders among them; at least one
    std::string where;                 ///< "on atrium/wide", "over 3 scenes with 9 views"
    std::string metric;                ///< within a sentence: "RMSE"
    std::string value;                 ///< the first one's, with all that is to be said of it
};

/// Names the closest of several methods, those that cannot be told apart from it, or the only method.
std::string closest_sentence(const ClosestMethods& methods);

}  // namespace aoscore
