#pragma once

#include "core/environment.h"
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

struct RecordedView;

/// A contestant on a view, to be scored and timed.
struct CellWork {
    std::string id;  ///< the cell's in the results: "atrium/wide/hbao/default"
    std::shared_ptr<const Contestant> contestant;
    std::optional<TruthQuery> own;  ///< the method's own truth, to score against beside the ranking's
    bool keep_image = true;         ///< write its output
    bool wants_times = true;        ///< whether its passes are timed, where the view's costs are wanted
    /// Whole lit frames are timed too, with a wait at their end and with one after every pass.
    bool whole_frames = false;
    bool repeats = false;             ///< whether it is drawn again with other seeds (jobs/repeats.h)
    bool lit_by_environment = false;  ///< whether its light is held against the view's irradiance
    /// Its own converged picture, against which it is held with its repeats.
    std::optional<MethodRequest> converged = {};
    MethodRequest timed;  ///< the contestant's, with its lighting where whole frames are timed
};

/// One view of a scene with everything to measure on it. Objects that it refers to must outlive it.
struct ViewWork {
    const Scene& scene;
    const View& view;
    SceneTools& tools;  ///< `scene` is chosen when work begins
    std::string gl_renderer, gl_version;
    int width = 0, height = 0;
    std::string key;                  ///< the view's in the results: "atrium/wide"
    double radius_m = 0;              ///< the ranking's radius
    std::vector<TruthQuery> queries;  ///< queries of the view's truth: the ranking's first
    TruthSettings truth;
    std::vector<TruthQuery> own_queries = {};  ///< methods' other queries, which are traced apart
    TruthSettings own_truth = {};              ///< settings for tracing those
    std::vector<CellWork> cells;
    MethodRequest fixed_pass;  ///< timed among the cells, with the lighting where that is timed
    std::optional<TimingGoal> timing_goal;
    bool timed = true;   ///< whether costs are wanted: times, and fetches a pixel
    bool untold = true;  ///< whether metrics are wanted that the truth's noise hides; see ScoreSettings
    double mask_threshold = 0.1;
    std::uint64_t seed = 1;
    /// What irradiance is traced and cells are lit under; null: nothing is lit.
    std::shared_ptr<const Environment> environment = nullptr;
    bool keep_gbuffer = true;
    std::set<std::string> kept_inputs;  ///< G-buffer inputs in its file beside those that cells read
    std::filesystem::path truth_cache;  ///< empty: none
    /// Where it is not null, G-buffer and truth are its files' and nothing is drawn or traced of `scene`.
    std::shared_ptr<const RecordedView> recorded = nullptr;
    std::string command;           ///< the command that makes the results again
    std::filesystem::path folder;  ///< the results' folder; images go below it

    /// Whether a cell keeps its image; then the view keeps its own.
    bool pictured() const;
    /// Whether the G-buffer's file has the surfaces behind one another as well: a cell that is pictured reads
    /// depth layers, which the page gathers from them.
    bool keeps_surfaces() const;
    /// Whether the cost of a frame without AO is measured, as pictures and timings to a goal ask for it.
    bool times_gbuffer() const;
    /// The G-buffer inputs that cells read, and the lighting where frames are lit.
    std::set<std::string> read_inputs() const;
    /// read_inputs() and the inputs that a stored file has.
    std::set<std::string> drawn_inputs() const;
    CameraFrame frame() const { return {view.camera, width, height}; }
    /// The requests of its truth, and of the truth of methods' own queries.
    TruthRequest truth_request() const;
    TruthRequest own_truth_request() const;
    /// Whether the view's truth has this query.
    bool ranks_by(const TruthQuery& query) const;

    /// Paths of files below `folder`.
    std::string truth_file() const;
    std::string gbuffer_file() const;
    std::string irradiance_file() const;
    std::string image_file(const CellWork& cell) const;
    std::string lit_file(const CellWork& cell) const;
};

/// Makes a file's name of an id: "atrium-wide".
std::string file_name(std::string id);

}  // namespace aoscore
