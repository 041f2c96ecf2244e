#pragma once

#include "jobs/contest/contestant.h"
#include "jobs/scene_tools.h"
#include "jobs/timing.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"
#include "store/truth/truth_request.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// A contestant on a view, as it is scored and timed.
struct CellWork {
    std::string id;  ///< of the cell in the results: "atrium/wide/hbao/default"
    std::shared_ptr<const Contestant> contestant;
    std::optional<TruthQuery>
        own;                 ///< a truth of the method's own to be scored against, beside the ranking's
    bool keep_image = true;  ///< write its output
    /// Also time whole lit frames, waited for at their end and after every pass.
    bool whole_frames = false;
    MethodRequest timed;  ///< the contestant's, with its lighting where whole frames are timed
};

/// One view of a scene and everything that is measured on it. What it refers to must outlive it.
struct ViewWork {
    const Scene& scene;
    const View& view;
    SceneTools& tools;  ///< `scene` is chosen when work begins
    std::string gl_renderer, gl_version;
    int width = 0, height = 0;
    std::string key;                  ///< of the view in the results: "atrium/wide"
    double radius_m = 0;              ///< of the ranking
    std::vector<TruthQuery> queries;  ///< of the view's truth: the ranking's first
    TruthSettings truth;
    std::vector<TruthQuery> own_queries = {};  ///< methods' own that are none of these: traced apart
    TruthSettings own_truth = {};              ///< how those are traced
    std::vector<CellWork> cells;
    MethodRequest fixed_pass;  ///< timed among the cells, with the lighting where that is timed
    std::optional<TimingGoal> timing_goal;
    bool timed = true;   ///< whether costs are wanted: times, and fetches a pixel
    bool untold = true;  ///< whether metrics are wanted that the truth's noise hides; see ScoreSettings
    double mask_threshold = 0.1;
    std::uint64_t seed = 1;
    bool keep_gbuffer = true;
    std::set<std::string> kept_inputs;  ///< of the G-buffer, in its file beside what the cells read
    std::filesystem::path truth_cache;  ///< empty: none
    std::string command;                ///< that makes the results again
    std::filesystem::path folder;       ///< of the results; images go below it

    /// Whether a cell keeps its image; then the view keeps its own.
    bool pictured() const;
    /// Whether what a frame costs without AO is asked for: by pictures, and by timings to a goal.
    bool times_gbuffer() const;
    /// The G-buffer inputs that the cells read, and the lighting where frames are lit.
    std::set<std::string> read_inputs() const;
    /// The same with those that are kept in a file, where one is.
    std::set<std::string> drawn_inputs() const;
    CameraFrame frame() const { return {view.camera, width, height}; }
    /// How its truth is asked for, and that of the methods' own queries.
    TruthRequest truth_request() const;
    TruthRequest own_truth_request() const;
    /// Whether the view's truth has this query.
    bool ranks_by(const TruthQuery& query) const;

    /// Below `folder`.
    std::string truth_file() const;
    std::string gbuffer_file() const;
    std::string image_file(const CellWork& cell) const;
};

/// A file's name made of an id: "atrium-wide".
std::string file_name(std::string id);

}  // namespace aoscore
