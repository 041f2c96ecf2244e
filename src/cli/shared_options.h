#pragma once

#include "core/folders.h"
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

/// Adds --size WxH, whose value is parsed into `size`.
void add_size_option(CLI::App& app, ImageSize& size);

/// Makes a check that a value is one of these names, whose error names the one that was probably meant.
CLI::Validator one_of(const std::vector<std::string>& names);

/// Adds --out, which is required: the path of an EXR file to write.
void add_exr_option(CLI::App& app, std::filesystem::path& path);

/// Adds --radius R[,R…], in metres, with "inf" allowed.
void add_radii_option(CLI::App& app, std::vector<double>& radii);
/// The one finite radius, metres, that `work` is done at; empty where the user named none. Throws usage_error
/// for several, and for an infinite one.
std::optional<double> one_finite_radius(const std::vector<double>& radii, const std::string& work);
/// Accepts an even number of rays a pixel: a truth of two halves.
CLI::Validator even_count();

/// The precision to which the truth is traced.
struct TruthEffort {
    std::optional<int> samples;         ///< the user's number; empty: none
    double max_error = 0;               ///< standard error to trace every pixel to; 0: none
    double mean_error = 0;              ///< standard error of the picture's mean; 0: none
    std::optional<double> score_error;  ///< the user's ScoreGoal::error; empty: none
    /// Rays a pixel, or the least number where an error is asked for: the user's, else the fewest that allow
    /// an error to be estimated where one is asked for, else 64.
    int least_samples() const;
};
/// Accepts a standard error that a truth can have.
CLI::Validator error_of_truth();
/// Adds --samples N and --error E.
void add_truth_options(CLI::App& app, TruthEffort& effort);

/// Adds --score-error E.
CLI::Option* add_score_error_option(CLI::App& app, std::optional<double>& error);
/// Adds the options of add_truth_options(), and --score-error E, which decides the rays where neither of
/// those is given.
void add_score_truth_options(CLI::App& app, TruthEffort& effort);
/// The goal that decides the rays of a view; none where the user named rays or an error.
std::optional<ScoreGoal> score_goal(const TruthEffort& effort);

/// Adds --no-cache, which empties `folder`, the folder for truths. Without it `folder` is the user's cache.
void add_cache_option(CLI::App& app, std::filesystem::path& folder);

/// Adds --causes, --one-layer-bound and --bent-normals.
void add_extras_options(CLI::App& app, TruthExtras& extras);

/// The chosen views of a scene, or the user's own camera.
struct ViewChoice {
    std::vector<std::string> views;  ///< choices for choose_views(); none: the scene's views of one kind
    LoadOptions load;                ///< with the given view file and camera
};
/// Adds --unit and --up.
void add_frame_options(CLI::App& app, LoadOptions& load);
/// Adds --view, --views, --eye, --target and --fovy; --unit and --up.
void add_view_options(CLI::App& app, ViewChoice& choice);
/// The choices of views, one for each plan; a single empty one where the user made none.
std::vector<std::string> planned_views(const ViewChoice& choice);

/// Adds SCENE as a positional, and the options of add_view_options().
struct SceneChoice {
    std::string scene;
    ViewChoice view;
};
void add_scene_options(CLI::App& app, SceneChoice& choice);

/// Loads the scene and prints its warnings.
Scene load_with_warnings(const std::string& name_or_path, const LoadOptions& options = {});

/// The chosen view for pictures of this size, or the first of several, with a note on standard error.
View one_view(const Scene& scene, const ViewChoice& choice, const ImageSize& size,
              const std::filesystem::path& cache = cache_dir());

}  // namespace aoscore
