#pragma once

#include "scene/scene.h"
#include "store/truth/truth_cache.h"

#include <map>
#include <string>

namespace aoscore {

/// The header of a truth file: all that its truth depends on, and `command`, which makes it again. Beside our
/// own attributes it has EXR's standard ones: comments (the command), capDate, and the matrices worldToCamera
/// (to a camera that looks down -z) and worldToNDC (-1 to 1 in the picture, after division by w).
std::map<std::string, std::string> truth_provenance(const Scene& scene, const CachedTruth& traced,
                                                    const std::string& command);

/// Names the code that traces truths, for people: the first digits of its digest.
std::string integrator_id();

/// The call of `aoscore reference` that traces this request again, into `out`. All queries must be binary.
std::string reference_command(const Scene& scene, const View& view, const TruthRequest& traced,
                              const std::string& out);

}  // namespace aoscore
