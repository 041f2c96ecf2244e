#pragma once

#include <filesystem>
#include <vector>

namespace aoscore {

/// The folder that holds shaders/, scenes/, reports/ and node_modules/, read-only where the program is
/// installed:
/// - the environment variable AOSCORE_DATA, where it is set;
/// - else share/aoscore in the nearest folder above the program that has one: a build's folder links it to
/// the source
///   tree, an installation keeps the files there;
/// - else /usr/share/aoscore.
/// Throws internal_error where none of them is there.
std::filesystem::path data_dir();

/// The folder for everything that is kept between runs: the environment variable AOSCORE_CACHE where it is
/// set; in a source tree its references/cache; where the program is installed, $XDG_CACHE_HOME/aoscore, or
/// ~/.cache/aoscore.
std::filesystem::path cache_dir();

/// Makes this the working folder. The folders that environment variables name stay the same, relative ones
/// among them.
void work_in(const std::filesystem::path& folder);

/// The folder in which a command makes the folder of its results: reports/out of a source tree; where the
/// program is installed, aoscore-out in the working folder.
std::filesystem::path results_dir();

/// Where scenes' view files lie, a folder a scene: first those of the user, $XDG_DATA_HOME/aoscore/scenes or
/// ~/.local/share/aoscore/scenes, then those of the program. Both folders may be missing.
std::vector<std::filesystem::path> scene_folders();

/// Where methods of other programs lie, a folder each: first those of the user,
/// $XDG_DATA_HOME/aoscore/contestants or ~/.local/share/aoscore/contestants, then those of the program. Both
/// folders may be missing.
std::vector<std::filesystem::path> contestant_folders();

}  // namespace aoscore
