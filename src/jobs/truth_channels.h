#pragma once

#include "core/signal.h"
#include "reference/truth.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// A picture of the first query that a truth may hold: a row of the one table that truth files, results, the
/// truth's signals and the command line's help are fed from. A new channel is a new row.
struct TruthChannel {
    std::string id;                      ///< that of the signal, where it is one; "cause.hidden", "one_layer"
    std::vector<std::string> exr_names;  ///< one a plane
    std::string meaning;                 ///< a noun with unit and range
    bool TruthExtras::*gathered_by = nullptr;  ///< the extra that has it traced; null: every truth has it
    /// The picture, empty where it was not traced; one of the two is set.
    std::function<const ImageF&(const Truth&)> number;
    std::function<const Image<glm::vec3>&(const Truth&)> direction;

    bool held_by(const Truth& truth) const;
    /// A copy of its planes, in the order of `exr_names`.
    SignalImage planes(const Truth& truth) const;
};

/// All channels, in the order in which files and results list them; visibility is the first.
const std::vector<TruthChannel>& truth_channels();
/// The row of this id. Throws internal_error where there is none.
const TruthChannel& truth_channel(std::string_view id);
/// The row that a file calls so. Throws internal_error where there is none.
const TruthChannel& truth_channel_in_files(std::string_view exr_name);

/// The channels that hold the visibility of query number `q` and its standard error: "V0.Y", "SE0.Y".
std::string query_channel(std::size_t q);
std::string query_error_channel(std::size_t q);
/// The channel that is 1 where a file's pixels show a surface.
inline constexpr std::string_view kMaskChannel = "mask.Y";

/// The ids of the row of Cause number `cause` and of the row of Truth::one_layer_bound.
std::string cause_channel_id(std::size_t cause);
inline constexpr std::string_view kOneLayerId = "one_layer";

/// "cause.outside.Y: the occlusion …; cause.hidden.Y: …": the channels that this extra adds, for the help.
std::string channels_gathered_by(bool TruthExtras::*extra);

}  // namespace aoscore
