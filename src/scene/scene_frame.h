#pragma once

#include "scene/scene.h"
#include "scene/view_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace aoscore {

/// The change of coordinates from a scene's file to the scene, which has metres and y up.
struct SceneFrame {
    double metres_per_unit = 1;
    glm::dmat3 y_up_from_file{1};  ///< a rotation, or a mirroring where a file's axes are left-handed
};

/// The rotation for files that have this axis up: z up becomes y up, and the front (-y) becomes z.
glm::dmat3 y_up_from(UpAxis up);

/// Applies the frame to instances and cameras. Bounds are not measured again.
void apply_frame(Scene& scene, const SceneFrame& frame);

/// Metres for a unit's name (m, cm, mm, in, ft, km), or for a positive number of metres. Nothing for another
/// text.
std::optional<double> parse_unit(std::string_view text);
/// The unit's name, "cm" for 0.01; the number itself where it has none.
std::string unit_text(double metres_per_unit);
/// The options of a command line for a file's unit and axes: " --unit cm --up z".
std::string frame_options(const LoadOptions& options);

/// Finds the frame in which a scene's bounds match those of a view file: unchanged, else by a uniform factor,
/// that of a common unit where one fits, and then the same with z up. `may_scale` and `may_turn` say what may
/// be chosen. Returns nothing where no frame fits within the file's tolerance.
std::optional<SceneFrame> recognise(const ViewFile& views, const Bounds& bounds, bool may_scale,
                                    bool may_turn);

}  // namespace aoscore
