#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Methods over depth layers, for the page: it gathers the layers from surfaces that were kept
/// (live_surfaces.h), and not all of them can be gathered so. Methods are as screen/method_data.h has them.

/// Something that the page does not run, with the reason.
struct LiveRefusal {
    std::string label;
    std::string reason;
};

/// Whether this input of a method holds depth layers, of the view's camera or of further ones.
bool is_layered_input(const std::string& input);

/// Says why these values of the method's parameters cannot be run; empty where they can. `samplings` are
/// those of the contract that kept surfaces serve.
std::string layers_refusal(const nlohmann::json& method, const nlohmann::json& values,
                           const nlohmann::json& samplings);

/// Leaves out the method's presets and choices that cannot be run, and adds to `refused` what it left out.
/// Returns false where no preset is left.
bool leave_out_presets(nlohmann::json& method, const nlohmann::json& samplings,
                       std::vector<LiveRefusal>& refused);

}  // namespace aoscore
