#pragma once

#include "image/visibility_file.h"
#include "jobs/contest/contestant.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace aoscore {

/// Images that another program has made of a scene's views, to be ranked among the methods: a folder with
/// contestant.json, see reports/README.md.
struct ImageFolder {
    std::filesystem::path folder;
    MethodDescriptor method;  ///< its id and label in results; it has no parameters and no passes
    ParameterValues stated;   ///< the cost that its program states, never ranked: "stated_ms" and "stated_on"
    VisibilityReading reading;
    std::map<std::string, std::string> images;  ///< files in the folder, by the view's id
};

/// Loads a folder. Throws file_error where contestant.json is missing or not understood. Missing images are
/// noticed only when they are scored.
ImageFolder load_image_folder(const std::filesystem::path& folder);

/// Makes a contestant of the folder's image of the view. image() reads it, and throws where it is missing,
/// has another size or cannot be read. Pixels that the file has no value for are NaN. `folder` must outlive
/// it.
std::shared_ptr<const Contestant> folder_image(const ImageFolder& folder, const std::string& view);

}  // namespace aoscore
