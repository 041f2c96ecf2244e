#include "jobs/contest/command_request.h"

#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "core/json_text.h"
#include "core/strict_json.h"
#include "jobs/image_output.h"
#include "scene/gltf/write_glb.h"

#include <fmt/format.h>

#include <map>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// The camera in the coordinates of the scene's .glb.
json camera_json(const CameraFrame& frame) {
    const Camera& camera = frame.camera();
    const bool perspective = camera.projection == Camera::Projection::perspective;
    json matrix = json::array();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) matrix.push_back(frame.view_from_world()[column][row]);
    }
    json result = {{"projection", perspective ? "perspective" : "orthographic"},
                   {"near_m", camera.near},
                   {"far_m", camera.far},
                   {"position_m", numbers(camera.position)},
                   {"target_m", numbers(camera.target)},
                   {"up", numbers(camera.up)},
                   {"world_to_camera", matrix}};
    if (perspective)
        result["fovy_deg"] = glm::degrees(camera.fovy_rad);
    else
        result["half_height_m"] = camera.half_height;
    return result;
}

std::string replaced(std::string word, const std::map<std::string, std::string>& values) {
    for (std::size_t open = word.find('{'); open != std::string::npos;) {
        const std::size_t close = word.find('}', open);
        const std::string& value = values.at(word.substr(open + 1, close - open - 1));
        word.replace(open, close - open + 1, value);
        open = word.find('{', open + value.size());
    }
    return word;
}

}  // namespace

std::vector<std::string> write_command_request(const OutsideMethod& outside, const CommandRun& run,
                                               const ContestantSources& sources, const fs::path& folder) {
    const OutsideCommand& command = outside.command.value();
    const CameraFrame& frame = sources.frame;
    std::map<std::string, std::string> values = {{"folder", outside.folder.string()},
                                                 {"request", (folder / "request.json").string()},
                                                 {"output", (folder / command.output).string()},
                                                 {"view", sources.view},
                                                 {"width", fmt::format("{}", frame.width())},
                                                 {"height", fmt::format("{}", frame.height())},
                                                 {"radius_m", fmt::format("{}", run.radius_m)},
                                                 {"seed", fmt::format("{}", run.seed)},
                                                 {"data", fs::absolute(data_dir()).string()},
                                                 {"scene", ""},
                                                 {"gbuffer", ""}};
    if (command.needs_scene) {
        if (sources.scene == nullptr || sources.scene->meshes.empty())
            throw file_error("needs a scene, and the view is a frame without one",
                             (outside.folder / "contestant.json").string() + ": command.needs");
        values["scene"] = (folder / "scene.glb").string();
        write_glb(*sources.scene, values["scene"]);
    }
    if (command.needs_gbuffer) {
        values["gbuffer"] = (folder / "gbuffer.exr").string();
        const GBufferImages drawn = sources.tools.renderer().read_gbuffer();
        write_gbuffer(values["gbuffer"], drawn, view_positions(drawn, frame), camera_attributes(frame, {}));
    }
    json request = {{"version", 1},
                    {"scene", values["scene"]},
                    {"gbuffer", values["gbuffer"]},
                    {"output", values["output"]},
                    {"cost", (folder / "cost.json").string()},
                    {"data", values["data"]},
                    {"view", sources.view},
                    {"width", frame.width()},
                    {"height", frame.height()},
                    {"radius_m", run.radius_m},
                    {"seed", run.seed},
                    {"preset", run.preset},
                    {"parameters", command.presets.at(run.preset)},
                    {"camera", camera_json(frame)}};
    write_atomically(values["request"], json_text(request, 2) + "\n");
    std::vector<std::string> words;
    for (const std::string& word : command.words) words.push_back(replaced(word, values));
    return words;
}

std::optional<ReportedCost> read_reported_cost(const fs::path& folder) {
    const fs::path file = folder / "cost.json";
    if (!fs::exists(file)) return std::nullopt;
    const json stored = parse_json_file(file);
    StrictObject object = StrictObject::of_file(stored, "cost.json");
    const ReportedCost cost{object.number("ms", 0, 1e9), object.text("on")};
    object.finish();
    return cost;
}

}  // namespace aoscore
