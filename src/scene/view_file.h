#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The beginning of the note of a view that nobody verified.
inline constexpr std::string_view kUnverified = "unverified: ";

/// The content of a view file, scenes/<id>/views.json: cameras by name for a scene that everybody has as the
/// same file. Coordinates are the scene's own (before any change of origin).
///
///     {"title": text, "verified": bool, "note": text (optional), "stems": [text] (optional),
///      "bounds": {"low": [x, y, z], "high": [x, y, z], "tolerance_m": n},
///      "views": [{"id": text, "position": [x, y, z], "target": [x, y, z], "up": [x, y, z] (default 0, 1, 0),
///                 "fovy_deg": n or "half_height_m": n (orthographic), "near_m": n, "far_m": n,
///                 "radius_m": n (optional)}]}
///
/// `stems` are other names of the scene's file, without extension, by which it is published. The bounds are
/// those of the scene that the views were made for. `verified` says whether somebody rendered the views with
/// that very scene; views that nobody verified say so in View::note.
struct ViewFile {
    std::string title;
    std::vector<std::string> stems;
    Bounds bounds;
    double tolerance_m = 0;
    std::vector<View> views;
};

/// The ids of the scenes that have a view file in scene_folders() of core/folders.h.
std::set<std::string> scenes_with_view_files();

/// The path of the view file for a scene id or file stem, whether it exists or not; where the user and the program have
/// one, the user's.
std::filesystem::path view_file_path(const std::string& id);

/// The path of the view file beside a scene's file, whether it exists or not: NAME.views.json for NAME.glb.
std::filesystem::path view_file_beside(const std::filesystem::path& scene_file);

/// The view files in scene_folders() that list this stem, the most exact bounds first.
std::vector<std::filesystem::path> view_files_of_stem(const std::string& stem);

/// Reads a view file. Throws file_error with file and place for unknown keys, missing or impossible values,
/// and repeated ids.
ViewFile read_view_file(const std::filesystem::path& path);

/// Whether a scene's bounds are those a view file was made for: every corner coordinate within the tolerance.
bool bounds_match(const ViewFile& views, const Bounds& bounds);

}  // namespace aoscore
