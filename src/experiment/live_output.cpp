#include "experiment/live_output.h"

#include "core/files.h"
#include "core/json_text.h"
#include "results/live_file.h"
#include "screen/method_data.h"
#include "screen/view_uniforms.h"

namespace aoscore {
namespace {

using nlohmann::json;

json view_data(const CameraFrame& frame) {
    const ViewUniforms view(frame);
    return {{"width", view.width},
            {"height", view.height},
            {"near_m", view.near},
            {"far_m", view.far},
            {"pixel_size", {view.pixel_size.x, view.pixel_size.y}},
            {"orthographic", view.orthographic}};
}

json descriptors(const std::vector<MethodDescriptor>& all, std::uint64_t seed) {
    json list = json::array();
    for (const MethodDescriptor& one : all) list.push_back(method_data(one, seed));
    return list;
}

}  // namespace

std::set<std::string> gbuffer_inputs_of(const Registry& registry) {
    std::set<std::string> inputs;
    for (const auto* descriptors_of : {&registry.methods, &registry.filters}) {
        for (const MethodDescriptor& one : *descriptors_of) {
            MethodRequest request;
            request.method = &one;
            inputs.merge(needed_gbuffer_inputs(request));
        }
    }
    return inputs;
}

void write_live_file(const std::filesystem::path& folder, const Registry& registry,
                     const std::filesystem::path& methods_dir,
                     const std::map<std::string, CameraFrame>& views, std::uint64_t seed) {
    json data = {{"contract", contract_data(seed)},
                 {"methods_dir", methods_dir.string()},
                 {"methods", descriptors(registry.methods, seed)},
                 {"filters", descriptors(registry.filters, seed)},
                 {"views", json::object()}};
    for (const auto& [key, frame] : views) data["views"][key] = view_data(frame);
    write_atomically(folder / kLiveFile, json_text(data) + "\n");
}

}  // namespace aoscore
