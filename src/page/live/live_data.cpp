#include "page/live/live_data.h"

#include "core/error.h"
#include "core/files.h"
#include "core/json_text.h"
#include "core/known_names.h"
#include "core/printable.h"
#include "core/strict_json.h"
#include "core/threads.h"
#include "image/channels.h"
#include "image/surface_channels.h"
#include "metrics/roles.h"
#include "page/document/page_template.h"
#include "page/live/live_index.h"
#include "page/live/live_packing.h"
#include "page/live/live_preview.h"
#include "page/live/live_surfaces.h"
#include "page/pictures/stored_images.h"
#include "results/live_file.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view kDepthChannel = "linear_depth";

/// An input of a view, full and as a preview.
struct PackedChannel {
    PackedInput full, preview;
};

PackedChannel pack_channel(const Channel& input, const ImageFile& file, const fs::path& path, int factor) {
    std::vector<const ImageF*> planes;
    for (const std::string_view name : input.exr_names)
        planes.push_back(&channel_of(file, path, std::string(name)));
    if (planes.size() == 1) return {pack_floats(*planes[0]), pack_floats(preview_of(*planes[0], factor))};
    Image<glm::vec3> vectors(file.width, file.height);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        vectors.pixels[i] = {planes[0]->pixels[i], planes[1]->pixels[i], planes[2]->pixels[i]};
    }
    return {pack_normals(vectors), pack_normals(preview_of(vectors, factor))};
}

std::set<std::string> inputs_of(const json& method) {
    std::set<std::string> inputs;
    for (const json& pass : method.at("passes")) {
        for (const json& input : pass.at("inputs")) inputs.insert(input.get<std::string>());
    }
    return inputs;
}

const json& samplings_of(const LiveData& data) {
    return data.index.at("contract").at("layer_samplings");
}

/// Says why a method cannot be run; empty when it can. Layered inputs are gathered from surfaces, which are
/// there in every view or not at all.
std::string refusal(const json& method, bool has_surfaces) {
    if (method.contains("processor")) {
        return fmt::format("computed on the processor ({}), not by shaders",
                           method.at("processor").get<std::string>());
    }
    for (const std::string& input : inputs_of(method)) {
        if (is_layered_input(input)) {
            if (has_surfaces && method.contains("depth_layers")) continue;
            return fmt::format("reads the input {}, {}", input,
                               method.contains("depth_layers")
                                   ? "for which the page holds surfaces where every view was measured with a "
                                     "method over depth layers"
                                   : "and the page holds no surfaces of further cameras");
        }
        const Channel* channel = find_row(gbuffer_channels(), input);
        const MadeInput* made = find_row(made_inputs(), input);
        const bool held = channel != nullptr ? channel->on_page : made != nullptr;
        if (!held) return fmt::format("reads the input {}, which the page does not hold", input);
    }
    return {};
}

void sort_out(LiveData& data) {
    const json& views = data.index.at("views");
    const bool has_surfaces =
        std::ranges::all_of(views, [](const json& view) { return view.at("surfaces").get<bool>(); });
    json runnable = json::array();
    for (json& method : data.index.at("methods")) {
        const std::string reason = refusal(method, has_surfaces);
        if (!reason.empty()) {
            data.refused.push_back({method.at("label").get<std::string>(), reason});
        } else if (leave_out_presets(method, samplings_of(data), data.refused)) {
            runnable.push_back(std::move(method));
        }
    }
    data.index["methods"] = std::move(runnable);
}

json cell_data(const CellRecord& cell) {
    json data = {{"id", cell.id},
                 {"method", cell.method},
                 {"preset", cell.preset},
                 {"filter", cell.filter},
                 {"parameters", cell.parameters}};
    for (const char* id : {kRankingMetric, kNoisyRankingMetric, kBiasMetric}) {
        const std::optional<double> value = value_of(cell.ranked, id);
        data[id] = value ? json(*value) : json();
    }
    return data;
}

/// Whether a measured cell can be drawn anew. The reason against it is added to what the page refuses, unless
/// its method or preset is refused already.
bool can_be_drawn(LiveData& live, const CellRecord& cell) {
    for (const json& method : live.index.at("methods")) {
        if (method.at("id") != cell.method) continue;
        if (!method.contains("depth_layers")) return true;
        if (!method.at("presets").contains(cell.preset)) return false;
        json values = method.at("presets").at(cell.preset);
        values.update(json(cell.parameters));
        const std::string reason = layers_refusal(method, values, samplings_of(live));
        if (!reason.empty()) live.refused.push_back({cell.id, reason});
        return reason.empty();
    }
    return true;
}

void add_view(LiveData& live, json& data, const ViewRecord& view, const Results& results) {
    data["scene"] = view.scene;
    data["view"] = view.view;
    data["radius_m"] = view.radius_m;
    data["samples"] = view.samples;
    data["noise_floor_rmse"] = view.truths.empty() ? 0.0 : view.truths.front().noise_floor_rmse;
    data["inputs"] = json::object();
    data["preview_inputs"] = json::object();
    data["cells"] = json::array();
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view.key && cell.error.empty() && can_be_drawn(live, cell))
            data["cells"].push_back(cell_data(cell));
    }
}

/// The inputs that some method or filter reads.
std::vector<const Channel*> wanted_inputs(const json& index) {
    std::set<std::string> names;
    for (const char* list : {"methods", "filters"}) {
        for (const json& one : index.at(list)) names.merge(inputs_of(one));
    }
    std::vector<const Channel*> wanted;
    for (const Channel& channel : gbuffer_channels()) {
        if (channel.on_page && names.contains(std::string(channel.id))) wanted.push_back(&channel);
    }
    return wanted;
}

void add_views(LiveData& data, const Results& results, const fs::path& folder) {
    for (const ViewRecord& view : results.views) {
        json& views = data.index.at("views");
        if (!views.contains(view.key)) {
            throw file_error("lacks the view " + view.key + " of the results beside it",
                             (folder / kLiveFile).string() + ": views");
        }
        add_view(data, views.at(view.key), view, results);
    }
}

bool reads_layers(const json& index) {
    return std::ranges::any_of(index.at("methods"),
                               [](const json& method) { return method.contains("depth_layers"); });
}

void add_surfaces(LiveData& data, const ViewRecord& view, const ImageFile& gbuffer, const fs::path& path,
                  const std::string& depth_block) {
    json& index = data.index.at("views").at(view.key);
    PackedSurfaces packed = pack_surfaces(
        gbuffer, path, index.at("far_m").get<double>(), "live " + view.key + " surfaces", depth_block,
        index.at("preview_factor").get<int>(), [&](std::string block, std::string text) {
            data.surface_blocks.insert(block);
            data.blocks.emplace_back(std::move(block), std::move(text));
        });
    index["surfaces"] = std::move(packed.index);
    index["preview_surfaces"] = std::move(packed.preview_index);
    if (packed.full_share == 0) return;
    data.cautions.push_back(fmt::format(
        "In {}, {:.1f} % of the pixels have {} surfaces behind one another or more, and the page "
        "holds {} of them: what methods over depth layers show there may differ from what the run "
        "measured.",
        view.key, 100 * packed.full_share, SurfaceChannels::kMost, SurfaceChannels::kMost));
}

}  // namespace

LiveData read_live_data(const Results& results, const fs::path& folder) {
    LiveData data;
    const fs::path path = folder / kLiveFile;
    if (!fs::exists(path)) {
        data.missing =
            fmt::format("These results have no {} beside them: a run of this version writes it.", kLiveFile);
        return data;
    }
    if (results.schema_version < Results::kSchemaVersion) {
        data.missing = fmt::format(
            "These results are of schema {}: the methods beside them were written for an earlier page. A run "
            "of "
            "this version writes them anew.",
            results.schema_version);
        return data;
    }
    if (std::any_of(results.views.begin(), results.views.end(),
                    [](const ViewRecord& view) { return view.gbuffer_file.empty(); })) {
        data.missing = "The run did not keep the G-buffer, which methods read.";
        return data;
    }
    data.index = parse_json_file(path);
    check_live_index(data.index, path.string());
    sort_out(data);
    add_views(data, results, folder);
    return data;
}

std::string add_gbuffer(LiveData& data, const ViewRecord& view, const ImageFile& gbuffer,
                        const fs::path& path) {
    if (!data.missing.empty()) return {};
    json& index = data.index.at("views").at(view.key);
    const int factor = preview_factor(view.width);
    index["preview_factor"] = factor;
    const std::vector<const Channel*> wanted = wanted_inputs(data.index);
    std::vector<PackedChannel> packed(wanted.size());
    parallel_for(wanted.size(),
                 [&](std::size_t i) { packed[i] = pack_channel(*wanted[i], gbuffer, path, factor); });
    std::string depth_block;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const std::string id(wanted[i]->id), name = fmt::format("live {} {}", view.key, id);
        const auto add = [&](const char* list, const std::string& block, PackedInput& input) {
            index[list][id] = {{"kind", input.kind}, {"data", block}};
            data.blocks.emplace_back(block, std::move(input.data));
        };
        add("inputs", name, packed[i].full);
        add("preview_inputs", name + " preview", packed[i].preview);
        if (id == kDepthChannel) depth_block = name;
    }
    if (reads_layers(data.index)) add_surfaces(data, view, gbuffer, path, depth_block);
    return depth_block;
}

std::string live_blocks(const LiveData& data) {
    if (!data.missing.empty()) return {};
    std::string text = data_block("live index", pack_text(printable_lines(json_text(data.index))));
    for (const auto& [name, packed] : data.blocks) text += data_block(name, packed);
    return text;
}

}  // namespace aoscore
