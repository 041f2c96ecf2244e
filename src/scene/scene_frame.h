#pragma once

#include "scene/scene.h"
#include "scene/view_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace aoscore {

/// How the coordinates of a scene's file become those of the scene, which are metres with y up.
struct SceneFrame {
    double metres_per_unit = 1;
    glm::dmat3 y_up_from_file{1};  ///< a rotation, or a mirroring where a file's axes are left-handed
};

/// The rotation for files that have this axis up: z up becomes y up, and what was in front (-y) is so again
/// (z).
glm::dmat3 y_up_from(UpAxis up);

/// Applies it to instances and cameras. Bounds are not measured again.
void apply_frame(Scene& scene, const SceneFrame& frame);

/// Metres for a unit's name (m, cm, mm, in, ft, km), or for a positive number of metres. Nothing for another
/// text.
std::optional<double> parse_unit(std::string_view text);
/// "cm" for 0.01; the number itself where it has no name.
std::string unit_text(double metres_per_unit);
/// The words of a command line that say what the options say of a file's unit and axes: " --unit cm --up z".
std::string frame_options(const LoadOptions& options);

/// The frame in which a scene with these bounds is the one that a view file was made for: the one it has,
/// else a uniform factor, that of a common unit where one fits, and then the same with z up. `may_scale` and
/// `may_turn` say what may still be chosen. Nothing where none fits within the file's tolerance.
std::optional<SceneFrame> recognise(const ViewFile& views, const Bounds& bounds, bool may_scale,
                                    bool may_turn);

}  // namespace aoscore
