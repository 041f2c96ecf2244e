#include "screen/method/side_layers.h"

#include "screen/method/input_members.h"

namespace aoscore {

const std::vector<Parameter>& side_layers_members() {
    static const std::vector<Parameter> all = [] {
        std::vector<Parameter> made = depth_layers_members();
        made.push_back({"cameras", Parameter::Type::integer, 1, 0, SideLayers::kMostCameras, {}, "", ""});
        made.push_back({"scale", Parameter::Type::integer, 1, 1, SideLayers::kMostScale, {}, "", ""});
        made.push_back({"right", Parameter::Type::real, 0.0, -1e7, 1e7, {}, "m", ""});
        made.push_back({"ahead", Parameter::Type::real, 0.0, -1e7, 1e7, {}, "m", ""});
        made.push_back({"aim", Parameter::Type::real, 0.0, 0, 1e7, {}, "m", ""});
        return made;
    }();
    return all;
}

SideLayers asked_side_layers(const InputMembers& input, const ParameterValues& parameters,
                             std::uint64_t run_seed) {
    const auto number = [&](const char* member) { return member_value(input, parameters, member).number(); };
    SideLayers side;
    side.cameras = static_cast<int>(number("cameras"));
    side.scale = static_cast<int>(number("scale"));
    side.right_m = number("right");
    side.ahead_m = number("ahead");
    side.aim_m = number("aim");
    side.layers = asked_depth_layers(input, parameters, run_seed);
    return side;
}

}  // namespace aoscore
