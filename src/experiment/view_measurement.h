#pragma once

#include "experiment/camera_contract.h"
#include "experiment/view_run.h"
#include "metrics/pixel_facts.h"

#include <map>
#include <span>
#include <string>

namespace aoscore {

/// One view made ready to be measured: its G-buffer drawn, its truth traced, each when it is first needed.
class ViewMeasurement {
  public:
    /// Fills in `view` as it goes. Both must outlive it.
    ViewMeasurement(const ViewRun& run, const CameraFrame& frame, ViewRecord& view)
        : run_(run), frame_(frame), view_(view) {}

    /// Draws the G-buffer; measures how long that takes where pictures are kept, once else.
    void draw();
    /// Traces the truth and checks that both paths see the same; draws before.
    void trace();
    /// Writes truth and G-buffer below the run's folder and names them in the view.
    void write_images();

    /// Runs the cell, writes its image where that is kept, and fills in its metrics and fetches. Throws where
    /// it fails.
    void measure(const ResolvedCell& cell, CellRecord& record);

    /// Traced now.
    std::uint64_t rays() const { return rays_; }

  private:
    void obtain_truth();
    void check_contract();
    MethodOutput output_of(const MethodRequest& request);
    MetricMap metrics_against(const TruthQuery& query, const ImageF& test, const Mask& valid,
                              std::span<const std::string> ids = {}) const;

    const ViewRun& run_;
    const CameraFrame& frame_;
    ViewRecord& view_;
    bool drawn_ = false, traced_ = false;
    Truth truth_;
    std::uint64_t rays_ = 0;
    std::map<std::string, std::string> header_;  // of the truth file
    GBufferImages gbuffer_;
    CameraContract contract_;
    PixelFacts facts_;
};

/// A file's name made of an id.
std::string file_name(std::string id);

}  // namespace aoscore
