#pragma once

#include "core/parameter_value.h"
#include "image/visibility_file.h"
#include "screen/method/method.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A command that makes an image of any view.
struct OutsideCommand {
    /// The program and its arguments, with placeholders such as {request}; no shell reads them.
    std::vector<std::string> words;
    std::vector<std::filesystem::path> files;  ///< of the folder, on whose content its image depends
    std::string version;                       ///< of the program behind it, on which its image depends, too
    double timeout_s = 120;                    ///< after which it is ended
    std::string output = "ao.exr";             ///< the name of the file that it writes
    bool needs_scene = false, needs_gbuffer = false;  ///< what is written for it
    std::map<std::string, ParameterValues> presets;   ///< what the request hands on, by preset

    /// The placeholders of `words`, with what each stands for.
    static const std::map<std::string, std::string>& placeholders();
};

/// A method of another program, to be ranked among the methods: a folder with contestant.json, see
/// reports/README.md. It has images of views, or a command that makes them.
struct OutsideMethod {
    std::filesystem::path folder;
    MethodDescriptor method;  ///< its id and label in results; it has no passes
    ParameterValues stated;   ///< the cost that its program states, never ranked: "stated_ms" and "stated_on"
    VisibilityReading reading;
    std::map<std::string, std::string> images;  ///< files in the folder, by the view's id
    std::optional<OutsideCommand> command;      ///< in place of images

    /// The values that results show for a preset: what is stated, and what the command is handed.
    ParameterValues shown_values(const std::string& preset) const;
};

/// Loads a folder. Throws file_error where contestant.json is missing or not understood, and where a file
/// that a command depends on is missing. Missing images are noticed only when they are scored.
OutsideMethod load_outside_method(const std::filesystem::path& folder);

/// The folder that a user means by a path, or by the id of a folder of contestants/ (the user's, then the
/// program's). Throws usage_error, which lists the known ids.
std::filesystem::path outside_folder(const std::string& path_or_id);
/// All such folders with their ids, those of the user first.
std::map<std::string, std::filesystem::path> outside_folders();

/// Reads an outside method's image of a view of this size. Pixels that the file has no value for are NaN.
/// Throws file_error for another size.
ImageF read_outside_image(const std::filesystem::path& file, const VisibilityReading& reading, int width,
                          int height);

}  // namespace aoscore
