#pragma once

#include "jobs/environment_light.h"
#include "jobs/executor.h"
#include "jobs/ground.h"
#include "jobs/repeats.h"
#include "jobs/score_image.h"
#include "jobs/stored_times.h"
#include "jobs/view_jobs.h"
#include "jobs/view_work.h"
#include "reference/irradiance.h"
#include "store/artifact_store.h"
#include "store/truth/truth_cache.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// Makes the artifacts of one view in this process, with Embree and OpenGL, and stores those that take long
/// to make. Large artifacts stay in memory as long as they are needed: the G-buffer, the truth, the image
/// made last.
class ViewMaker final : public Maker {
  public:
    /// All arguments must outlive this object. `view` is described, without measurements.
    ViewMaker(const ViewWork& work, const ViewJobs& jobs, const ArtifactStore& store, const ViewRecord& view);

    bool take(const Job& job) override;
    bool take_input(const Job& job) override;
    void make(const Job& job) override;
    std::vector<std::string> make_in_turns(std::span<const Job* const> jobs) override;

    // The artifacts of the results that were taken or made; null before that.
    const ViewRecord* view() const { return view_ ? &*view_ : nullptr; }
    const PassRuns* gbuffer_runs() const { return gbuffer_runs_ ? &*gbuffer_runs_ : nullptr; }
    const Score* score(const Key& key) const;
    const OwnScore* own_score(const Key& key) const;
    const double* fetches(const Key& key) const;
    const Repeats* repeats(const Key& key) const;
    const LightRecord* view_light() const { return view_light_ ? &*view_light_ : nullptr; }
    const LightErrors* light(const Key& key) const;
    const StoredTimes* times(const Key& key) const;

    // The artifacts in memory that others are made of; null where there is none.
    const GBufferImages* gbuffer() const { return gbuffer_ ? &*gbuffer_ : nullptr; }
    const Truth* truth() const { return truth_ ? &truth_->truth : nullptr; }
    const Ground* ground() const { return ground_ ? &*ground_ : nullptr; }
    const MethodOutput* image() const { return image_ ? &image_->second : nullptr; }
    /// The time of the last drawing of the G-buffer, milliseconds.
    double drawn_ms() const { return drawn_ms_; }

    /// The number of rays traced now.
    std::uint64_t rays() const { return rays_; }

  private:
    bool take_payload(const Job& job);
    bool take_irradiance(const Job& job);
    bool take_image(const Job& job);
    void read_payload(const Job& job, const nlohmann::json& payload);
    void keep(const Job& job, const nlohmann::json& payload) { store_.put(job.key.hex, payload); }

    void draw(const std::set<std::string>& inputs);
    CachedTruth trace(TruthRequest request, const std::string& what);
    void make_gbuffer_file(const Job& job);
    void make_image(const Job& job);
    void make_score(const Job& job);
    void make_irradiance(const Job& job);
    void make_view_light(const Job& job);
    void make_light(const Job& job);
    void make_lit_file(const Job& job);
    EnvironmentLight light();
    void make_own_score(const Job& job);
    void make_repeats(const Job& job);

    const CellWork& cell(const Job& job) const { return work_.cells[job.cell]; }

    const ViewWork& work_;
    const ArtifactStore& store_;
    const ViewRecord& described_;
    CameraFrame frame_;
    std::set<Key> pictured_;  ///< images that are stored in files

    std::set<std::string> drawn_inputs_;
    double drawn_ms_ = 0;  ///< time of the last drawing
    std::optional<GBufferImages> gbuffer_;
    std::optional<CachedTruth> truth_, own_truth_;
    std::optional<Ground> ground_;
    std::optional<std::pair<Key, ContestantImage>> image_;
    std::optional<Irradiance> irradiance_;
    std::optional<EnvironmentCones> cones_;  ///< of the environment
    std::optional<TruthSide> truth_side_;    ///< side of the ranking's truth on the ground
    std::uint64_t rays_ = 0;
    LayersDrawn layers_drawn_;

    std::optional<ViewRecord> view_;
    std::optional<PassRuns> gbuffer_runs_;
    std::map<Key, Score> scores_;
    std::map<Key, OwnScore> own_scores_;
    std::map<Key, double> fetches_;
    std::map<Key, Repeats> repeats_;
    std::optional<LightRecord> view_light_;
    std::map<Key, LightErrors> lights_;
    std::map<Key, StoredTimes> times_;
};

}  // namespace aoscore
