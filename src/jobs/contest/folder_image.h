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
    MethodDescriptor method;  ///< how results name it: id and label; it has no parameters and no passes
    ParameterValues stated;   ///< a cost that its program states, never ranked: "stated_ms" and "stated_on"
    VisibilityReading reading;
    std::map<std::string, std::string> images;  ///< files in the folder, by the view's id
};

/// Throws file_error where contestant.json is not there or not understood. Whether its images are there is
/// seen only when they are scored.
ImageFolder load_image_folder(const std::filesystem::path& folder);

/// The folder's image of the view, read when it is asked for: where it is missing, has another size or cannot
/// be read, image() throws. Pixels that the file has no value for are NaN. `folder` must outlive it.
std::shared_ptr<const Contestant> folder_image(const ImageFolder& folder, const std::string& view);

}  // namespace aoscore
