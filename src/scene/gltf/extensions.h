#pragma once

#include <nlohmann/json_fwd.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore::gltf {

/// What a glTF extension is to a picture of surfaces.
struct Extension {
    enum class Effect {
        read,      ///< honoured where it decides what surfaces there are
        none,      ///< changes colours, lights, motion or metadata alone: no surface is elsewhere for it
        surfaces,  ///< may add, move, hide or cut surfaces, and is not read
    };
    std::string_view name;
    Effect effect;
    std::string_view loss = {};  ///< Effect::surfaces: what the picture lacks without it
};

/// The one table of extensions, by the registry of the Khronos Group (glTF repository, extensions/2.0, 2026)
/// and what is seen in files.
const std::vector<Extension>& extensions();

/// Names of all extensions that objects of the document carry, declared in extensionsUsed or not.
std::set<std::string> extensions_carried(const nlohmann::json& root);

/// What to warn of for an extension that is used and not required; empty when nothing is lost. One that is
/// not in the table is warned of: nobody knows what it changes.
std::string loss_without(const std::string& name);

/// Whether a file that requires the extension is read rightly.
bool is_honoured(std::string_view name);

}  // namespace aoscore::gltf
