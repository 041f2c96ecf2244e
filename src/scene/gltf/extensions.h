#pragma once

#include <nlohmann/json_fwd.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore::gltf {

/// A glTF extension and its effect on a picture of surfaces.
struct Extension {
    enum class Effect {
        read,      ///< honoured where it affects surfaces
        none,      ///< changes colours, lights, motion or metadata alone, and no surface
        surfaces,  ///< may add, move, hide or cut surfaces, and is not read
    };
    std::string_view name;
    Effect effect;
    std::string_view loss = {};  ///< for Effect::surfaces: what the picture lacks without it
};

/// The one table of extensions, by the registry of the Khronos Group (glTF repository, extensions/2.0, 2026)
/// and by files in use.
const std::vector<Extension>& extensions();

/// Names of all extensions that objects of the document carry, declared in extensionsUsed or not.
std::set<std::string> extensions_carried(const nlohmann::json& root);

/// The loss to warn of when an extension is used and not required; empty when nothing is lost. Extensions
/// that are not in the table may lose anything.
std::string loss_without(const std::string& name);

/// Whether a file that requires the extension is read correctly.
bool is_honoured(std::string_view name);

}  // namespace aoscore::gltf
