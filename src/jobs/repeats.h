#pragma once

#include "jobs/ground.h"
#include "metrics/analysis/repeats.h"
#include "reference/truth.h"
#include "screen/screen.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

// This is a file of its own, because the code of repeats is the code that the linker takes for it
// (aoscore_code_digests() in CMakeLists.txt).
namespace aoscore {

/// What estimators find over the first depth layer and over all, by the digests of both requests: cells that
/// differ only in how they sample layers share it.
struct LayersDrawn {
    static constexpr std::size_t kMost = 8;
    std::map<std::string, HiddenOcclusion> by_digest;  ///< of one view; all are forgotten beyond kMost
};

/// A request to draw again, and the one that makes its converged picture where it is held against that.
struct RepeatRequest {
    const MethodRequest& request;
    const std::optional<MethodRequest>& converged;
};

/// Draws a request again on the renderer's current G-buffer, with Repeats::kSeeds seeds that follow its own,
/// and where it reads depth layers, over the first layer and over all. What is hidden from the truth is told
/// where it was traced with its causes; signals where it holds them. The converged picture is the mean over
/// as many seeds.
Repeats repeat_image(ScreenRenderer& renderer, const RepeatRequest& asked, const Truth& truth,
                     const Ground& ground, LayersDrawn& drawn);

nlohmann::json to_json(const Repeats& repeats);
/// Reads repeats. Throws file_error for another form.
Repeats repeats_from_json(const nlohmann::json& json, const std::string& where);

}  // namespace aoscore
