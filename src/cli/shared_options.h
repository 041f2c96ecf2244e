#pragma once

#include "core/image_size.h"
#include "core/log.h"
#include "plan/plan.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "store/truth/truth_cache.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

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
    std::optional<int> samples;         ///< as the user named them
    double max_error = 0;               ///< 0, or the standard error that every pixel is traced to
    double mean_error = 0;              ///< 0, or that of the mean over the picture
    std::optional<double> score_error;  ///< as the user named it: ScoreGoal::error
    /// Rays a pixel, the fewest where an error is asked for: those named, else as few as tell an error where
    /// one is asked for, else 64.
    int least_samples() const;
};
/// --samples N and --error E.
void add_truth_options(CLI::App& app, TruthEffort& effort);

/// --score-error E.
CLI::Option* add_score_error_option(CLI::App& app, std::optional<double>& error);
/// The options of add_truth_options(), and --score-error E, which decides the rays where neither of the two
/// is given.
void add_score_truth_options(CLI::App& app, TruthEffort& effort);
/// The goal that decides the rays of a view; none where the user named rays or an error.
std::optional<ScoreGoal> score_goal(const TruthEffort& effort);

/// --no-cache: leaves `folder`, that of the kept truths, empty. Without it `folder` is the user's cache.
void add_cache_option(CLI::App& app, std::filesystem::path& folder);

/// --causes, --one-layer-bound and --bent-normals.
void add_extras_options(CLI::App& app, TruthExtras& extras);

/// Which of a scene's views, and cameras of the user's own.
struct ViewChoice {
    std::vector<std::string> views;  ///< as choose_views() takes them; none: the scene's views of one kind
    LoadOptions load;                ///< with the view file and the camera that were given
};
/// --view, --views, --eye, --target and --fovy; --unit and --up.
void add_view_options(CLI::App& app, ViewChoice& choice);
/// The choices of views, one for each plan: one empty one where none was made.
std::vector<std::string> planned_views(const ViewChoice& choice);

/// SCENE as a positional and the options of add_view_options().
struct SceneChoice {
    std::string scene;
    ViewChoice view;
};
void add_scene_options(CLI::App& app, SceneChoice& choice);

/// Loads the scene and prints its warnings.
Scene load_with_warnings(const std::string& name_or_path, const LoadOptions& options = {});

/// The chosen view for pictures of this size, or the first (said on standard error where there are several).
View one_view(const Scene& scene, const ViewChoice& choice, const ImageSize& size,
              const std::filesystem::path& cache = default_cache_dir());

}  // namespace aoscore
