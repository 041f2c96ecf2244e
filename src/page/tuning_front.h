#pragma once

#include "results/tuning_record.h"

#include <string>
#include <vector>

namespace aoscore {

/// Settings of a method on the page: what they cost and how far they are.
struct TunedPoint {
    std::string name;       ///< "GTAO, default", "GTAO, tuned-24"
    std::string of_method;  ///< points of one method are joined
    bool tuned = false;     ///< else as published
    double fetches = 0;     ///< a pixel
    double loss = 0;
    bool on_front = false;  ///< no point has less loss at no more fetches
};

/// The published and the tuned settings of all methods, on the views that were tuned on; the front is over
/// all of them.
std::vector<TunedPoint> tuned_points(const TuningRecord& tuning);

/// A chart of them as SVG: fetches to the right in even factors, loss upwards.
std::string tuned_points_svg(const std::vector<TunedPoint>& points, const std::string& loss_label);

}  // namespace aoscore
