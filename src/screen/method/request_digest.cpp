#include "screen/method/request_digest.h"

#include "core/folders.h"
#include "core/hash.h"
#include "core/json_text.h"
#include "screen/passes/pass_program.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

void add_descriptor(Digest& digest, const MethodRequest& request, const MethodDescriptor& method,
                    const ParameterValues& parameters, bool orthographic) {
    digest.text(json_text(parameters));
    digest.text(method.depth_mips.filter).text(method.depth_mips.radius_parameter);
    for (const std::optional<InputMembers>* layers : {&method.depth_layers, &method.side_layers}) {
        if (*layers) digest.text(json_text((*layers)->members));
    }
    for (const Pass& pass : method.passes) {
        digest.text(pass.processor).value(pass.scale);
        for (const std::string& input : pass.inputs) digest.text(input);
        if (!pass.processor.empty()) continue;
        PassBuild build;
        build.method = &method;
        build.parameters = &parameters;
        build.seed = request.seed;
        build.orthographic = orthographic;
        build.border_far = request.border == Border::far;
        build.uniform_form = request.uniform_form;
        build.mirror = request.mirror;
        if (&method == request.method && &pass == &method.passes.back()) build.signals = request.signals;
        digest.text(pass_source(build, pass).text());
    }
}

// Adds the shaders that draw the G-buffer and compute inputs from it.
void add_input_shaders(Digest& digest) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(data_dir() / "shaders" / "gbuffer"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        digest.text(file.filename().string()).text(expanded_text(file, file.parent_path()));
}

}  // namespace

std::string request_digest(const MethodRequest& request, bool orthographic) {
    Digest digest;
    digest.value(request.seed).value(request.border).value(request.normals).value(request.resolution);
    digest.value(request.precision).text(text_of(request.guard_band));
    add_descriptor(digest, request, *request.method, request.parameters, orthographic);
    digest.value(request.filter != nullptr);
    if (request.filter != nullptr)
        add_descriptor(digest, request, *request.filter, request.filter_parameters, orthographic);
    digest.value(request.lighting != nullptr);
    if (request.lighting != nullptr)
        add_descriptor(digest, request, *request.lighting, request.lighting_parameters, orthographic);
    add_input_shaders(digest);
    return digest.hex();
}

}  // namespace aoscore
