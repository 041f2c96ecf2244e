#include "page/live/live_layers.h"

#include "core/known_names.h"
#include "image/channels.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

using nlohmann::json;

/// The parameter that holds a member of "depth_layers" or "side_layers"; empty where the descriptor fixes it.
std::string parameter_of(const json& members, const char* member) {
    const json& value = members.at(member);
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    return text.starts_with('@') ? text.substr(1) : "";
}

const json& member_of(const json& members, const char* member, const json& values) {
    const std::string parameter = parameter_of(members, member);
    return parameter.empty() ? members.at(member) : values.at(parameter);
}

/// The parameter's entry; null where the member is fixed.
json* parameter_entry(json& method, const char* input, const char* member) {
    const std::string id = parameter_of(method.at(input), member);
    for (json& parameter : method.at("parameters")) {
        if (!id.empty() && parameter.at("id") == id) return &parameter;
    }
    return nullptr;
}

/// Marks what no surfaces serve among the choices that menus and sliders offer. They keep their places, which
/// are their numbers in shaders.
void narrow_parameters(json& method, const json& samplings) {
    if (json* sampling = parameter_entry(method, "depth_layers", "sampling")) {
        json& not_here = (*sampling)["not_here"] = json::array();
        for (const json& choice : sampling->at("choices")) {
            if (!samplings.contains(choice.get<std::string>())) not_here.push_back(choice);
        }
    }
    if (!method.contains("side_layers")) return;
    if (json* cameras = parameter_entry(method, "side_layers", "cameras")) cameras->at("high") = 0;
}

}  // namespace

bool is_layered_input(const std::string& input) {
    const MadeInput* made = find_row(made_inputs(), input);
    return made != nullptr && made->layered;
}

std::string layers_refusal(const json& method, const json& values, const json& samplings) {
    if (method.contains("side_layers") && member_of(method.at("side_layers"), "cameras", values) != 0)
        return "reads depth layers of further cameras, whose surfaces the page does not hold";
    if (!method.contains("depth_layers")) return {};
    const auto sampling = member_of(method.at("depth_layers"), "sampling", values).get<std::string>();
    if (samplings.contains(sampling)) return {};
    return fmt::format("takes depth layers by the sampling {}, which needs the scene", sampling);
}

bool leave_out_presets(json& method, const json& samplings, std::vector<LiveRefusal>& refused) {
    if (!method.contains("depth_layers") && !method.contains("side_layers")) return true;
    const auto label = method.at("label").get<std::string>();
    json left = json::object();
    for (const auto& [preset, values] : method.at("presets").items()) {
        const std::string reason = layers_refusal(method, values, samplings);
        if (reason.empty())
            left[preset] = values;
        else
            refused.push_back({fmt::format("{}, preset {}", label, preset), reason});
    }
    method["presets"] = std::move(left);
    if (method.at("presets").empty()) return false;
    if (method.contains("depth_layers")) narrow_parameters(method, samplings);
    return true;
}

}  // namespace aoscore
