#pragma once

#include "metrics/metric.h"

#include <optional>

namespace aoscore {

/// The part of the occlusion that no method over one depth layer can find which an image shows, at the
/// strength that is right where one layer is enough. `one_layer` is the occlusion that one layer shows at
/// most. A value in [0,1], but 0 is no proof of ignorance, nor 1 of knowledge: an image that is too dark at
/// the right places has some of it, too. Empty where one layer is enough everywhere, or the image is open
/// everywhere. Throws sizes_differ.
std::optional<double> found_beyond_layer(const MetricInput& input, const ImageF& one_layer);

}  // namespace aoscore
