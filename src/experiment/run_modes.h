#pragma once

#include "screen/screen.h"

#include <map>
#include <string>

namespace aoscore {

/// The names, on the command line and in results, of the modes that any method can be run in.
const std::map<std::string, Border>& border_names();
const std::map<std::string, Normals>& normals_names();
const std::map<std::string, Resolution>& resolution_names();

/// The name of a mode; `names` has every value.
template <class Mode>
std::string name_of(const std::map<std::string, Mode>& names, Mode mode) {
    for (const auto& [name, value] : names) {
        if (value == mode) return name;
    }
    return {};
}

}  // namespace aoscore
