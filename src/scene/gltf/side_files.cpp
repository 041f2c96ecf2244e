#include "scene/gltf/side_files.h"

#include "core/error.h"
#include "core/text.h"
#include "scene/gltf/asset_folder.h"
#include "scene/gltf/container.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace aoscore::gltf {

namespace fs = std::filesystem;

std::vector<fs::path> side_files(const fs::path& file) {
    const std::string ending = lower_case(file.extension().string());
    if (ending != ".gltf" && ending != ".glb") return {};
    std::vector<fs::path> files;
    try {
        std::vector<std::string> warnings;
        const std::unique_ptr<const Container> container = read_container(file, file.string(), warnings);
        const auto asset = nlohmann::json::parse(container->json, nullptr, /*allow_exceptions=*/false);
        if (!asset.is_object()) return {};
        for (const char* kind : {"buffers", "images"}) {
            for (const nlohmann::json& entry : asset.value(kind, nlohmann::json::array())) {
                const auto uri = entry.is_object() ? entry.find("uri") : entry.end();
                if (uri == entry.end() || !uri->is_string()) continue;
                const std::string& name = uri->get_ref<const std::string&>();
                if (!is_data_uri(name))
                    files.push_back(file.parent_path() / check_relative_uri(name, file.string()));
            }
        }
    } catch (const Error&) {
        return {};
    }
    return files;
}

}  // namespace aoscore::gltf
