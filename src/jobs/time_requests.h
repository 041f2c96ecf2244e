#pragma once

#include "jobs/timing.h"
#include "screen/screen.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A request to time, with its lighting where whole frames are wanted.
struct TimedRequest {
    MethodRequest request;
    bool whole_frames = false;
};

/// The timed runs of one request, in the order they were taken.
struct RequestTimes {
    PassRuns ao;
    std::vector<double> layers_processor_ms;  ///< the part that draws depth layers; empty without them
    PassRuns filter;                          ///< empty without a filter
    PassRuns lighting;                        ///< empty without lighting
    PassRuns gbuffer;                         ///< of the picture with its guard band; empty without one
    double gbuffer_bytes = 0;                 ///< of the G-buffer, with its guard band
    PassRuns frame_at_once, frame_by_pass;    ///< empty where no whole frames are asked for
    std::string error;                        ///< why the runs ended early; empty when they did not
};

/// Times requests on the renderer's current G-buffer: a warm-up each, then round by round over all of them,
/// so that a disturbance of the machine meets all alike; each timed_runs() times, or until `goal` is reached.
/// `what` names the work for its progress. Throws interrupted_error on Ctrl-C.
std::vector<RequestTimes> time_requests(ScreenRenderer& renderer, const std::vector<TimedRequest>& requests,
                                        const std::optional<TimingGoal>& goal, const std::string& what);

/// Draws the last G-buffer again for the clock.
PassRuns time_gbuffer(ScreenRenderer& renderer, double first_ms);

}  // namespace aoscore
