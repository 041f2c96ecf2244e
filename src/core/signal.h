#pragma once

#include "core/image.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The planes of one signal's image, in the order of Signal::channels.
using SignalImage = std::vector<ImageF>;

/// A quantity that an image may hold: a row of the table in signal.cpp. A pass of a method writes it as
/// `o_<id>`, the truth holds it with a standard error, metrics compare the two (see metrics/signal_metric.h).
struct Signal {
    std::string_view id;  ///< its name on the command line, in JSON and in GLSL
    std::string_view label;
    std::string_view meaning;  ///< one sentence for the page
    std::string_view unit;     ///< the unit of its values; "" for pure numbers
    double low = 0, high = 1;  ///< the range of a plane
    /// Names of the channels in image files, one a plane; a shader's output has as many components.
    std::span<const std::string_view> channels;
    std::string_view error_channel;  ///< holds the standard error in truth files
};

/// The id of the signal that every method gives.
inline constexpr std::string_view kVisibilitySignal = "visibility";

/// The one table of signals; visibility is the first. Where there is no surface visibility is 1, and all
/// others are 0.
std::span<const Signal> signals();
/// The row of this id. Throws usage_error that lists the known ids.
const Signal& signal(std::string_view id);
/// The ids of all signals but visibility: a method gives these only where it is asked for them.
std::vector<std::string> further_signals();

}  // namespace aoscore
