#include "scene/gltf/structure.h"

#include "scene/gltf/extensions.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore::gltf {
namespace {

/// Reads "2.0" as 20; -1 when the text is no version.
int version_number(const std::string& text) {
    const std::size_t dot = text.find('.');
    if (dot == std::string::npos || dot == 0 || dot + 1 == text.size() || text.size() > 6) return -1;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::string major = text.substr(0, dot), minor = text.substr(dot + 1);
    if (!std::all_of(major.begin(), major.end(), is_digit) ||
        !std::all_of(minor.begin(), minor.end(), is_digit)) {
        return -1;
    }
    return std::stoi(major) * 1000 + std::stoi(minor);
}

/// A few names for messages.
std::string honoured_geometry() {
    std::string names;
    for (const Extension& extension : extensions()) {
        const std::string_view name = extension.name;
        if (extension.effect != Extension::Effect::read || name.find("texture") != std::string_view::npos)
            continue;
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
    return names;
}

}  // namespace

void check_asset_and_extensions(CheckedObject& root, const std::set<std::string>& carried,
                                std::vector<std::string>& warnings) {
    root.required_object("asset", [&](CheckedObject& asset) {
        const int version = version_number(asset.required_text("version"));
        if (version / 1000 != 2 || version < 0) asset.fail("version", "is another version of glTF", "2.x");
        if (asset.has("minVersion")) {
            const int least = version_number(asset.text("minVersion"));
            if (least < 0 || least > 2000) asset.fail("minVersion", "asks for more than glTF 2.0", "2.0");
        }
    });

    const std::vector<std::string> required = root.texts("extensionsRequired");
    const std::vector<std::string> used = root.texts("extensionsUsed");
    for (const std::string& name : required) {
        if (!is_honoured(name)) {
            root.fail("extensionsRequired", "needs " + printable(name) + ", which is not supported",
                      "extensions that are read, such as " + honoured_geometry());
        }
        if (std::find(used.begin(), used.end(), name) == used.end()) {
            warnings.push_back("extensionsRequired names " + printable(name) +
                               ", which extensionsUsed lacks");
        }
    }
    std::set<std::string> all = carried;
    all.insert(used.begin(), used.end());
    for (const std::string& name : all) {
        const std::string loss = loss_without(name);
        if (!loss.empty()) warnings.push_back(loss);
    }
}

void check_structure(nlohmann::json& json, const std::string& where, std::vector<std::string>& warnings) {
    const Place file(where);
    CheckedObject root(json, file);
    check_asset_and_extensions(root, extensions_carried(json), warnings);
    const Counts counts{root.count("buffers"), root.count("bufferViews"), root.count("accessors"),
                        root.count("meshes"),  root.count("materials"),   root.count("textures"),
                        root.count("images"),  root.count("samplers"),    root.count("nodes"),
                        root.count("cameras"), root.count("skins"),       root.count("scenes")};
    for (const char* array : {"buffers", "bufferViews", "accessors", "meshes", "materials", "textures",
                              "images", "samplers", "nodes", "cameras", "skins", "scenes", "animations"}) {
        root.objects(array, [](CheckedObject& element, std::size_t) { element.text("name"); });
    }
    check_buffers_and_accessors(root, counts, warnings);
    check_meshes(root, counts, warnings);
    check_nodes_and_scenes(root, counts, warnings);
    check_cameras(root, warnings);
    check_materials_and_textures(root, counts, warnings);
}

}  // namespace aoscore::gltf
