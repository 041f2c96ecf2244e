#include "tuning/tuning_definition.h"

#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "core/image_size.h"
#include "core/known_names.h"
#include "core/strict_json.h"
#include "metrics/metric.h"
#include "scene/scene.h"

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTried = 100000;

/// What load_scene() takes for the definition's scene: an id of its own, or the path of a file.
std::string scene_to_load(const std::string& scene, const fs::path& scenes_dir, const std::string& where) {
    if (!scene.ends_with(".glb") && !scene.ends_with(".gltf") && !scene.ends_with(".obj")) {
        row_in_file(builtin_scenes(), scene, where);
        return scene;
    }
    const fs::path file = scenes_dir / scene;
    if (!fs::is_regular_file(file))
        throw usage_error(
            "the definition's scene " + scene + " is not there", file.string(),
            "--scenes-dir with the folder that holds it; scenes/README.md says where to get it");
    return file.string();
}

TuningPlan::OnScene read_scene(StrictObject object, const fs::path& scenes_dir) {
    TuningPlan::OnScene on;
    on.scene = scene_to_load(object.text("scene"), scenes_dir, object.where("scene"));
    on.views = object.texts_or_empty("views");
    if (on.views.empty())
        throw file_error("names no view", object.where("views"), "ids of the scene's views");
    object.finish();
    return on;
}

SearchEffort read_effort(StrictObject& object) {
    return {object.integer("evaluations", 1, kMostTried), object.integer("refinements", 0, kMostTried)};
}

TuningPlan::Method read_method(StrictObject object, const std::vector<MethodDescriptor>& methods) {
    const std::string id = object.text("method");
    TuningPlan::Method method;
    method.cell = scored_cells(row_in_file(methods, id, object.where("method"))).front();
    method.cell.preset = object.text_or("preset", "default");
    method.parameters = object.texts_or_empty("parameters");
    if (object.has("evaluations")) method.effort = read_effort(object);
    object.finish();
    return method;
}

/// Checks the methods that are named as not tuned: each with a reason, and none that is.
void check_left_out(StrictObject left_out, const TuningPlan& plan,
                    const std::vector<MethodDescriptor>& methods) {
    for (const auto& [id, reason] : left_out.members()) {
        row_in_file(methods, id, left_out.where());
        if (!reason.is_string() || reason.get<std::string>().empty())
            throw file_error("gives no reason", left_out.where(id), "a text");
        const auto is_it = [&id = id](const TuningPlan::Method& tuned) { return tuned.cell.method == id; };
        if (std::ranges::any_of(plan.methods, is_it))
            throw file_error("is tuned all the same", left_out.where(id));
    }
}

void keep_methods(const std::vector<std::string>& methods, TuningPlan& plan) {
    std::vector<std::string> tuned;
    for (const TuningPlan::Method& method : plan.methods) tuned.push_back(method.cell.method);
    for (const std::string& method : methods) {
        if (std::ranges::find(tuned, method) == tuned.end())
            throw unknown_name("no method of the definition", method, tuned, "--methods");
    }
    std::erase_if(plan.methods, [&](const TuningPlan::Method& method) {
        return std::ranges::find(methods, method.cell.method) == methods.end();
    });
}

}  // namespace

fs::path tuning_definition_file(const std::string& name) {
    if (name.ends_with(".json")) return name;
    const fs::path folder = data_dir() / "reports" / "tunings";
    std::vector<std::string> known;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
        if (entry.path().extension() == ".json") known.push_back(entry.path().stem().string());
    }
    std::ranges::sort(known);
    if (std::ranges::find(known, name) == known.end())
        throw unknown_name("no tuning", name, known, "--definition", "or the path of a definition");
    return folder / (name + ".json");
}

void read_tuning_definition(const fs::path& file, const fs::path& scenes_dir,
                            const std::vector<std::string>& methods, TuningPlan& plan) {
    const nlohmann::json definition = parse_json_file(file);
    StrictObject object = StrictObject::of_file(definition, file.string());
    plan.definition = object.text("id");
    object.text("title");
    plan.metric = object.text_or("metric", plan.metric);
    row_in_file(metrics(), plan.metric, object.where("metric"));
    const ImageSize size = read_image_size(object);
    plan.width = size.width;
    plan.height = size.height;
    plan.samples = object.integer("samples", 2, 1 << 20);
    if (plan.samples % 2 != 0)
        throw file_error("is odd", object.where("samples"), "an even number: the truth has two halves");
    plan.effort = read_effort(object);
    const std::vector<MethodDescriptor> known = load_methods();
    for (StrictObject& method : object.objects("methods"))
        plan.methods.push_back(read_method(std::move(method), known));
    if (object.has("left_out")) check_left_out(object.object("left_out"), plan, known);
    if (!methods.empty()) keep_methods(methods, plan);
    // A scene may have to be fetched first: a misspelt method is said before that.
    for (StrictObject& scene : object.objects("scenes"))
        plan.scenes.push_back(read_scene(std::move(scene), scenes_dir));
    object.finish();
}

}  // namespace aoscore
