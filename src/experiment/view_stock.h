#pragma once

#include "experiment/measurement_store.h"
#include "experiment/stored_times.h"
#include "experiment/view_run.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// What of a view's run is in the store, and under which keys what is missing will be put there.
///
/// A cell's key is a digest of all that decides its numbers: the code that measures, OpenGL's version, the
/// scene, the camera and its size, the truth it is held against, the request's assembled shaders, parameters,
/// modes and seed. Times have the machine in theirs besides, and what is timed in the same rounds.
struct ViewStock {
    std::string view_key, truth_file_key, gbuffer_file_key;
    std::vector<std::string> cell_keys, time_keys, image_keys;

    std::optional<ViewRecord> view;
    std::vector<std::optional<CellRecord>> cells;  ///< without times
    std::vector<std::optional<StoredTimes>> times;

    bool has(std::size_t cell) const { return cells[cell].has_value() && times[cell].has_value(); }
    std::size_t missing() const;
    /// Nothing is left to measure.
    bool complete() const { return view.has_value() && missing() == 0; }
};

/// Looks everything up; measures nothing.
ViewStock take_stock(const ViewRun& run, const MeasurementStore& store);

/// Everything that is ranked or scored against on this view: the ranking's query, then each method's own.
std::vector<TruthQuery> wanted_queries(const ViewRun& run, double radius_m);
/// How its truth is traced.
TruthSettings truth_settings(const ViewRun& run);

}  // namespace aoscore
