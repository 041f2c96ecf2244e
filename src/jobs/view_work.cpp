#include "jobs/view_work.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

std::string file_name(std::string id) {
    std::replace(id.begin(), id.end(), '/', '-');
    return id;
}

bool ViewWork::pictured() const {
    return std::any_of(cells.begin(), cells.end(), [](const CellWork& cell) { return cell.keep_image; });
}

bool ViewWork::keeps_surfaces() const {
    return keep_gbuffer && std::ranges::any_of(cells, [](const CellWork& cell) {
               const MethodRequest* request = cell.contestant->timed_request();
               return cell.keep_image && request != nullptr && request->method->depth_layers;
           });
}

bool ViewWork::times_gbuffer() const {
    return timed && recorded == nullptr && (pictured() || timing_goal.has_value());
}

std::set<std::string> ViewWork::read_inputs() const {
    std::set<std::string> inputs;
    if (fixed_pass.method != nullptr) inputs = needed_gbuffer_inputs(fixed_pass);
    for (const CellWork& cell : cells) {
        if (auto read = cell.contestant->gbuffer_inputs()) inputs.merge(*read);
    }
    return inputs;
}

std::set<std::string> ViewWork::drawn_inputs() const {
    std::set<std::string> inputs = read_inputs();
    if (pictured()) inputs.insert(kept_inputs.begin(), kept_inputs.end());
    return inputs;
}

TruthRequest ViewWork::truth_request() const {
    return {scene.digest, view.camera, width, height, queries, truth, TraceBuild()};
}

TruthRequest ViewWork::own_truth_request() const {
    return {scene.digest, view.camera, width, height, own_queries, own_truth, TraceBuild()};
}

bool ViewWork::ranks_by(const TruthQuery& query) const {
    return std::ranges::find(queries, query) != queries.end();
}

std::string ViewWork::truth_file() const {
    return fmt::format("views/{}-truth.exr", file_name(key));
}

std::string ViewWork::gbuffer_file() const {
    return fmt::format("views/{}-gbuffer.exr", file_name(key));
}

std::string ViewWork::irradiance_file() const {
    return fmt::format("views/{}-irradiance.exr", file_name(key));
}

std::string ViewWork::image_file(const CellWork& cell) const {
    return fmt::format("cells/{}.exr", file_name(cell.id));
}

std::string ViewWork::lit_file(const CellWork& cell) const {
    return fmt::format("cells/{}-lit.exr", file_name(cell.id));
}

}  // namespace aoscore
