#include "jobs/contest/outside_method.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/known_names.h"
#include "core/strict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription = "contestant.json";
constexpr double kLongest_s = 24 * 3600;

/// The value that stands for one of the names, in their order.
template <class Value>
Value choice(StrictObject& object, const char* key,
             const std::vector<std::pair<std::string, Value>>& choices) {
    const std::string chosen = object.text(key);
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
        if (name == chosen) return value;
        names.push_back(name);
    }
    throw unknown_name_in_file(chosen, names, object.where(key));
}

std::string plain_id(StrictObject& object) {
    const std::string id = object.text("id");
    const bool plain = !id.empty() && id.front() != '-' && std::ranges::all_of(id, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
    if (!plain)
        throw file_error(fmt::format("\"{}\" is no id", id), object.where("id"),
                         "lower-case letters, digits and '-'");
    return id;
}

std::map<std::string, std::string> images_by_view(StrictObject object) {
    std::map<std::string, std::string> images;
    for (const auto& [view, file] : object.members()) {
        if (!file.is_string() || file.get<std::string>().empty())
            throw file_error("is " + file.dump(), object.where(view), "a file's name in the folder");
        images[view] = file.get<std::string>();
    }
    if (images.empty()) throw file_error("names no image", object.where(), "files by the id of their view");
    return images;
}

/// Throws file_error for a placeholder that there is none of.
void check_placeholders(const std::vector<std::string>& words, const std::string& where) {
    for (const std::string& word : words) {
        for (std::size_t open = word.find('{'); open != std::string::npos; open = word.find('{', open + 1)) {
            const std::size_t close = word.find('}', open);
            const std::string name = word.substr(open + 1, close - open - 1);
            std::vector<std::string> known;
            for (const auto& [id, meaning] : OutsideCommand::placeholders()) known.push_back(id);
            if (std::ranges::find(known, name) == known.end()) throw unknown_name_in_file(name, known, where);
        }
    }
}

OutsideCommand read_command(StrictObject object, const fs::path& folder) {
    OutsideCommand command;
    command.words = object.texts_or_empty("words");
    if (command.words.empty())
        throw file_error("names no program", object.where("words"),
                         R"(such as ["python3", "{folder}/ao.py"])");
    check_placeholders(command.words, object.where("words"));
    for (const std::string& file : object.texts_or_empty("files")) {
        if (!fs::is_regular_file(folder / file))
            throw file_error(file + " is not there", object.where("files"), "files of the folder");
        command.files.push_back(folder / file);
    }
    command.version = object.text("version");
    command.timeout_s = object.number_or("timeout_s", command.timeout_s, 0.1, kLongest_s);
    command.output = object.text_or("output", command.output);
    if (fs::path(command.output).filename() != command.output || command.output.empty())
        throw file_error("is " + command.output, object.where("output"), "a file's name, such as ao.exr");
    for (const std::string& need : object.texts_or_empty("needs")) {
        if (need != "scene" && need != "gbuffer")
            throw unknown_name_in_file(need, {"scene", "gbuffer"}, object.where("needs"));
        (need == "scene" ? command.needs_scene : command.needs_gbuffer) = true;
    }
    if (object.has("presets")) {
        StrictObject presets = object.object("presets");
        for (const auto& [id, values] : presets.members()) {
            if (!values.is_object()) throw file_error("is " + values.dump(), presets.where(id), "an object");
            command.presets[id] = parameter_values(StrictObject(values, presets.where(id)));
        }
    }
    if (command.presets.empty()) command.presets["default"];
    object.finish();
    return command;
}

void read_source(StrictObject& object, OutsideMethod& result) {
    if (object.has("command") == object.has("images"))
        throw file_error(
            object.has("command") ? "has a command and images" : "has neither images nor a command",
            object.where(), "one of them");
    if (object.has("images")) {
        result.images = images_by_view(object.object("images"));
        result.method.presets["default"];
        return;
    }
    result.command = read_command(object.object("command"), result.folder);
    for (const auto& [id, values] : result.command->presets) result.method.presets[id];
}

}  // namespace

const std::map<std::string, std::string>& OutsideCommand::placeholders() {
    static const std::map<std::string, std::string> all = {
        {"folder", "the folder of contestant.json"},
        {"request", "a JSON file with all of the request"},
        {"output", "the file to write"},
        {"scene", "the scene as .glb, in metres, y up"},
        {"gbuffer", "the G-buffer as EXR"},
        {"view", "the view's id"},
        {"width", "pixels"},
        {"height", "pixels"},
        {"radius_m", "the AO radius, metres"},
        {"seed", "of random numbers"},
        {"data", "the folder with the program's node_modules"}};
    return all;
}

ParameterValues OutsideMethod::shown_values(const std::string& preset) const {
    ParameterValues values = stated;
    if (command) values.insert(command->presets.at(preset).begin(), command->presets.at(preset).end());
    return values;
}

OutsideMethod load_outside_method(const fs::path& folder) {
    const nlohmann::json json = parse_json_file(folder / kDescription);
    StrictObject object = StrictObject::of_file(json, (folder / kDescription).string());
    OutsideMethod result;
    result.folder = fs::absolute(folder);
    result.method.id = plain_id(object);
    result.method.label = object.text("label");
    const Coding coding =
        choice<Coding>(object, "encoding", {{"linear", Coding::linear}, {"srgb", Coding::srgb}});
    result.reading.coding = coding;
    result.reading.srgb_floats = coding == Coding::srgb;
    result.reading.invert = choice<bool>(object, "signal", {{"visibility", false}, {"occlusion", true}});
    result.reading.channel = object.text_or("channel", "");
    object.texts_or_empty("notes");
    read_source(object, result);
    if (object.has("stated_cost")) {
        StrictObject cost = object.object("stated_cost");
        result.stated["stated_ms"] = cost.number("ms", 0, 1e9);
        result.stated["stated_on"] = cost.text("on");
        cost.finish();
    }
    object.finish();
    return result;
}

std::map<std::string, fs::path> outside_folders() {
    std::map<std::string, fs::path> folders;
    std::error_code ec;
    for (const fs::path& folder : contestant_folders()) {
        for (const auto& entry : fs::directory_iterator(folder, ec)) {
            if (fs::is_regular_file(entry.path() / kDescription, ec))
                folders.emplace(entry.path().filename().string(), entry.path());
        }
    }
    return folders;
}

fs::path outside_folder(const std::string& path_or_id) {
    if (fs::exists(fs::path(path_or_id) / kDescription)) return path_or_id;
    const std::map<std::string, fs::path> folders = outside_folders();
    if (const auto found = folders.find(path_or_id); found != folders.end()) return found->second;
    if (fs::is_directory(path_or_id))
        throw file_error("has no contestant.json", path_or_id, "a folder with one");
    std::vector<std::string> known;
    for (const auto& [id, folder] : folders) known.push_back(id);
    throw unknown_name("no contestant", path_or_id, known, "--contestant",
                       "or a folder with contestant.json");
}

ImageF read_outside_image(const fs::path& file, const VisibilityReading& reading, int width, int height) {
    VisibilityFile read = read_visibility(file, reading);
    ImageF& image = read.visibility;
    if (image.width != width || image.height != height) {
        throw file_error(fmt::format("is {}x{} pixels", image.width, image.height), file.string(),
                         fmt::format("{}x{}, as the view is rendered", width, height));
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (read.mask.pixels[i] == 0) image.pixels[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return std::move(image);
}

}  // namespace aoscore
