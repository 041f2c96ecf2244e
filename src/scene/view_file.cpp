#include "scene/view_file.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/strict_json.h"
#include "scene/view_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace aoscore {

namespace fs = std::filesystem;

namespace {

constexpr double kLargest = 1e12;  // limit for numbers that must be positive
constexpr double kSmallest = std::numeric_limits<float>::min();

glm::dvec3 vector_in(StrictObject& object, std::string_view key) {
    const std::vector<double> v = object.numbers(key, 3);
    for (const double coordinate : v) {
        if (!is_float32(coordinate))
            throw file_error(fmt::format("holds {:g}", coordinate), object.where(key),
                             "finite float32 numbers");
    }
    return {v[0], v[1], v[2]};
}

double positive(StrictObject& object, std::string_view key, double highest = kLargest) {
    const double value = object.number(key, 0, highest);
    if (value < kSmallest)
        throw file_error(fmt::format("is {:g}", value), object.where(key), "more than 0, a normal float32");
    return value;
}

View read_view(StrictObject& object) {
    View view;
    view.id = object.text("id");
    if (view.id.empty()) throw file_error("is empty", object.where("id"), "a name");
    Camera& camera = view.camera;
    camera.position = vector_in(object, "position");
    camera.target = vector_in(object, "target");
    if (object.has("up")) camera.up = vector_in(object, "up");
    if (object.has("fovy_deg") == object.has("half_height_m")) {
        throw file_error("needs one of fovy_deg and half_height_m", object.where());
    }
    if (object.has("fovy_deg")) {
        camera.projection = Camera::Projection::perspective;
        camera.fovy_rad = positive(object, "fovy_deg", 179.0) * std::numbers::pi / 180.0;
    } else {
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = positive(object, "half_height_m");
    }
    camera.near = positive(object, "near_m");
    camera.far = positive(object, "far_m");
    if (!(camera.far > camera.near)) throw file_error("is not beyond near_m", object.where("far_m"));
    if (object.has("radius_m")) view.radius_m = positive(object, "radius_m");
    object.finish();
    try {
        CameraFrame(camera, 16, 9);
    } catch (const Error& e) {
        throw file_error(std::string("has no picture: ") + e.what(), object.where());
    }
    return view;
}

}  // namespace

fs::path view_file_path(const std::string& id) {
    const std::vector<fs::path> folders = scene_folders();
    for (const fs::path& folder : folders) {
        if (fs::path path = folder / id / "views.json"; fs::exists(path)) return path;
    }
    return folders.back() / id / "views.json";
}

fs::path view_file_beside(const fs::path& scene_file) {
    return scene_file.parent_path() / (scene_file.stem().string() + ".views.json");
}

std::set<std::string> scenes_with_view_files() {
    std::set<std::string> ids;
    std::error_code ec;
    for (const fs::path& folder : scene_folders()) {
        for (const auto& entry : fs::directory_iterator(folder, ec)) {
            if (fs::exists(entry.path() / "views.json")) ids.insert(entry.path().filename().string());
        }
    }
    return ids;
}

std::vector<fs::path> view_files_of_stem(const std::string& stem) {
    std::vector<std::pair<double, fs::path>> found;
    for (const std::string& id : scenes_with_view_files()) {
        const fs::path path = view_file_path(id);
        const ViewFile file = read_view_file(path);
        if (std::find(file.stems.begin(), file.stems.end(), stem) != file.stems.end())
            found.emplace_back(file.tolerance_m, path);
    }
    std::sort(found.begin(), found.end());
    std::vector<fs::path> paths;
    for (auto& [tolerance, path] : found) paths.push_back(std::move(path));
    return paths;
}

ViewFile read_view_file(const fs::path& path) {
    const nlohmann::json json = parse_json_file(path);
    // Errors and pages name the file as users know it: from the project's root on.
    const fs::path relative = path.lexically_relative(data_dir());
    const std::string name =
        relative.empty() || *relative.begin() == ".." ? path.string() : relative.generic_string();
    StrictObject root = StrictObject::of_file(json, name);
    ViewFile file;
    file.title = root.text("title");
    if (!root.has("verified")) throw file_error("is missing", root.where("verified"), "true or false");
    const bool verified = root.boolean_or("verified", false);
    const std::string note = root.text_or("note", "");
    file.stems = root.texts_or_empty("stems");

    StrictObject bounds = root.object("bounds");
    file.bounds.low = vector_in(bounds, "low");
    file.bounds.high = vector_in(bounds, "high");
    file.tolerance_m = positive(bounds, "tolerance_m");
    bounds.finish();

    std::set<std::string> ids;
    for (StrictObject& object : root.objects("views")) {
        View view = read_view(object);
        if (!ids.insert(view.id).second) throw file_error("is there twice", object.where("id"), "unique ids");
        view.source = name;
        if (!note.empty()) view.note = note;
        if (!verified)
            view.note = std::string(kUnverified) + (note.empty() ? "nobody rendered this view yet" : note);
        file.views.push_back(std::move(view));
    }
    if (file.views.empty()) throw file_error("is empty", root.where("views"), "at least one view");
    root.finish();
    return file;
}

bool bounds_match(const ViewFile& views, const Bounds& bounds) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(views.bounds.low[axis] - bounds.low[axis]) <= views.tolerance_m)) return false;
        if (!(std::abs(views.bounds.high[axis] - bounds.high[axis]) <= views.tolerance_m)) return false;
    }
    return true;
}

}  // namespace aoscore
