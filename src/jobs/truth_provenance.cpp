#include "jobs/truth_provenance.h"

#include "core/files.h"
#include "core/machine.h"
#include "core/processes/shell.h"
#include "store/code_digest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <vector>

namespace aoscore {
namespace {

/// The matrix row by row for row vectors, which is column by column for ours.
std::string matrix_text(const glm::dmat4& matrix) {
    std::vector<double> numbers;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) numbers.push_back(matrix[column][row]);
    }
    return fmt::format("{}", fmt::join(numbers, " "));
}

/// Writes 2026-11-22T02:11:47Z as EXR does: 2026:11:22 02:11:47.
std::string exr_date(std::string utc) {
    utc.replace(4, 1, ":").replace(7, 1, ":").replace(10, 1, " ");
    utc.pop_back();
    return utc;
}

}  // namespace

std::string integrator_id() {
    return std::string(code_digest("truth").substr(0, 12));
}

std::map<std::string, std::string> truth_provenance(const Scene& scene, const CachedTruth& traced,
                                                    const std::string& command) {
    const TruthRequest& made_for = traced.made_for;
    const CameraFrame frame(made_for.camera, made_for.width, made_for.height);
    const glm::dmat4 camera_from_world =
        frame.view_from_world() * glm::translate(glm::dmat4(1.0), -scene.origin);
    return {{"aoscore:scene", scene.id},
            {"aoscore:scene_digest", scene.digest},
            {"aoscore:seed", fmt::format("{}", made_for.settings.seed)},
            {"aoscore:least_samples", fmt::format("{}", made_for.settings.samples)},
            {"aoscore:max_error", fmt::format("{}", made_for.settings.max_error)},
            {"aoscore:mean_error", fmt::format("{}", made_for.settings.mean_error)},
            {"aoscore:halves", made_for.settings.halves ? "yes" : "no"},
            {"aoscore:shading_normals", made_for.settings.shading_normals ? "yes" : "no"},
            {"aoscore:integrator", integrator_id()},
            {"aoscore:version", std::string(version())},
            {"capDate", exr_date(utc_now())},
            {"comments", command},
            {"worldToCamera", matrix_text(camera_from_world)},
            {"worldToNDC", matrix_text(frame.clip_from_view() * camera_from_world)}};
}

std::string reference_command(const Scene& scene, const View& view, const TruthRequest& traced,
                              const std::string& out) {
    const TruthSettings& settings = traced.settings;
    std::vector<std::string> radii;
    for (const TruthQuery& query : traced.queries) {
        radii.push_back(std::isfinite(query.radius_m) ? fmt::format("{}", query.radius_m) : "inf");
    }
    std::string command = fmt::format("aoscore reference {} {} --size {}x{} --radius {} --samples {}",
                                      shell_quoted(scene_name(scene)), view.options, traced.width,
                                      traced.height, fmt::join(radii, ","), settings.samples);
    if (settings.max_error > 0) command += fmt::format(" --error {}", settings.max_error);
    if (settings.mean_error > 0) command += fmt::format(" --mean-error {}", settings.mean_error);
    if (settings.halves) command += " --halves";
    if (settings.shading_normals) command += " --shading-normals";
    if (settings.extras.causes) command += " --causes";
    if (settings.extras.one_layer_bound) command += " --one-layer-bound";
    if (settings.extras.bent_normals) command += " --bent-normals";
    return command + fmt::format(" --seed {} --no-cache --out {}", settings.seed, shell_quoted(out));
}

}  // namespace aoscore
