#pragma once

#include "core/log.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

struct ImageSize {
    int width = 1920, height = 1080;
};

/// --size WxH. The option's value lands in `size` while parsing.
void add_size_option(CLI::App& app, ImageSize& size);

/// A check that a value is one of these names; says which one was meant.
CLI::Validator one_of(const std::vector<std::string>& names);

/// --out, required: an EXR file to write, by its extension.
void add_exr_option(CLI::App& app, std::filesystem::path& path);

/// --radius R[,R…]: metres, "inf" allowed.
void add_radii_option(CLI::App& app, std::vector<double>& radii);

/// How finely the truth is traced.
struct TruthEffort {
    int samples = 64;      ///< rays a pixel; the fewest where max_error is set
    double max_error = 0;  ///< 0, or the standard error that every pixel is traced to
};
/// --samples N and --error E.
void add_truth_options(CLI::App& app, TruthEffort& effort);

/// --no-cache: leaves `folder`, that of the kept truths, empty. Without it `folder` is the user's cache.
void add_cache_option(CLI::App& app, std::filesystem::path& folder);

/// --causes, --one-layer-bound and --bent-normals.
void add_extras_options(CLI::App& app, TruthExtras& extras);

/// SCENE as a positional and --view.
struct SceneChoice {
    std::string scene;
    std::string view;  ///< empty: all of the scene's views, or the first where only one makes sense
};
void add_scene_options(CLI::App& app, SceneChoice& choice);

/// Loads the scene and prints its warnings.
Scene load_with_warnings(const std::string& name_or_path, const LoadOptions& options = {});

/// The chosen view, or the scene's first (said on standard error where there are several).
const View& one_view(const Scene& scene, const std::string& view_id);

}  // namespace aoscore
