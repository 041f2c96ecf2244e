#include "jobs/contest/folder_image.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
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

class FolderImage final : public Contestant {
  public:
    FolderImage(const ImageFolder& folder, std::string view) : folder_(folder), view_(std::move(view)) {}

    std::string_view code() const override { return "folder_image"; }

    std::string digest(bool) const override {
        const VisibilityReading& reading = folder_.reading;
        Digest digest;
        digest.text(reading.channel).value(reading.coding == Coding::srgb).value(reading.invert);
        std::error_code ec;
        const fs::path file = path();
        if (fs::is_regular_file(file, ec)) digest.text(read_file(file));
        return digest.hex();
    }

    MethodOutput image(const ContestantSources& sources) const override {
        const fs::path file = path();
        if (file.empty()) {
            throw file_error("has no image of the view " + view_,
                             (folder_.folder / kDescription).string() + ": images");
        }
        VisibilityFile read = read_visibility(file, folder_.reading);
        ImageF& image = read.visibility;
        const int width = sources.frame.width(), height = sources.frame.height();
        if (image.width != width || image.height != height) {
            throw file_error(fmt::format("is {}x{} pixels", image.width, image.height), file.string(),
                             fmt::format("{}x{}, as the view is rendered", width, height));
        }
        for (std::size_t i = 0; i < image.size(); ++i) {
            if (read.mask.pixels[i] == 0) image.pixels[i] = std::numeric_limits<float>::quiet_NaN();
        }
        return {image, image, {}, {}};
    }

  private:
    /// Empty where the folder names none for the view.
    fs::path path() const {
        const auto found = folder_.images.find(view_);
        return found == folder_.images.end() ? fs::path() : folder_.folder / found->second;
    }

    const ImageFolder& folder_;
    std::string view_;
};

}  // namespace

ImageFolder load_image_folder(const fs::path& folder) {
    const nlohmann::json json = parse_json_file(folder / kDescription);
    StrictObject object = StrictObject::of_file(json, (folder / kDescription).string());
    ImageFolder result;
    result.folder = folder;
    result.method.id = plain_id(object);
    result.method.label = object.text("label");
    result.method.presets["default"];
    const Coding coding =
        choice<Coding>(object, "encoding", {{"linear", Coding::linear}, {"srgb", Coding::srgb}});
    result.reading.coding = coding;
    result.reading.srgb_floats = coding == Coding::srgb;
    result.reading.invert = choice<bool>(object, "signal", {{"visibility", false}, {"occlusion", true}});
    result.reading.channel = object.text_or("channel", "");
    result.images = images_by_view(object.object("images"));
    if (object.has("stated_cost")) {
        StrictObject cost = object.object("stated_cost");
        result.stated["stated_ms"] = cost.number("ms", 0, 1e9);
        result.stated["stated_on"] = cost.text("on");
        cost.finish();
    }
    object.finish();
    return result;
}

std::shared_ptr<const Contestant> folder_image(const ImageFolder& folder, const std::string& view) {
    return std::make_shared<FolderImage>(folder, view);
}

}  // namespace aoscore
