#include "experiment/run_modes.h"

namespace aoscore {

const std::map<std::string, Border>& border_names() {
    static const std::map<std::string, Border> names{{"far", Border::far}, {"clamp", Border::clamp}};
    return names;
}

const std::map<std::string, Normals>& normals_names() {
    static const std::map<std::string, Normals> names{{"as-described", Normals::as_described},
                                                      {"geometric", Normals::geometric},
                                                      {"smooth", Normals::smooth},
                                                      {"from-depth", Normals::from_depth},
                                                      {"from-depth-accurate", Normals::from_depth_accurate}};
    return names;
}

const std::map<std::string, Resolution>& resolution_names() {
    static const std::map<std::string, Resolution> names{{"full", Resolution::full},
                                                         {"half", Resolution::half},
                                                         {"dual", Resolution::dual},
                                                         {"half-gbuffer", Resolution::half_gbuffer}};
    return names;
}

}  // namespace aoscore
