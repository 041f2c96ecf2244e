#include "plan/view_description.h"

#include "results/view_piece.h"
#include "scene/view_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/glm.hpp>

#include <algorithm>

namespace aoscore {
namespace {

std::vector<double> coordinates(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

ViewRecord describe_view(const Scene& scene, const View& view, const CameraFrame& frame,
                         const std::string& key) {
    const Camera& camera = view.camera;
    ViewRecord record;
    record.key = key;
    record.scene = scene.id;
    record.view = view.id;
    record.scene_digest = scene.digest;
    record.view_source = view.source;
    record.view_note = view.note;
    record.triangles = scene.triangle_count;
    record.width = frame.width();
    record.height = frame.height();
    record.position_m = coordinates(camera.position + scene.origin);
    record.target_m = coordinates(camera.target + scene.origin);
    record.up = coordinates(camera.up);
    if (camera.projection == Camera::Projection::perspective) {
        record.projection = "perspective";
        record.fovy_deg = glm::degrees(camera.fovy_rad);
    } else {
        record.projection = "orthographic";
        record.half_height_m = camera.half_height;
    }
    record.near_m = camera.near;
    record.far_m = camera.far;
    record.warnings = scene.warnings;
    return record;
}

std::string view_file_text(const Scene& scene, const std::vector<View>& views) {
    // Wide enough for the rounding of exporters, narrow enough to tell scenes apart.
    constexpr double kTolerance = 1e-3;
    nlohmann::ordered_json file;
    file["title"] = scene.id;
    file["verified"] =
        std::ranges::none_of(views, [](const View& view) { return view.note.starts_with(kUnverified); });
    file["bounds"] = {{"low", coordinates(scene.bounds.low + scene.origin)},
                      {"high", coordinates(scene.bounds.high + scene.origin)},
                      {"tolerance_m", kTolerance * scene.bounds.diagonal()}};
    std::vector<std::string> pieces;
    for (const View& view : views) {
        ViewRecord record = describe_view(scene, view, CameraFrame(view.camera, 16, 9), view.id);
        record.radius_m = view.radius_m.value_or(0);
        pieces.push_back("    " + view_piece(record).dump());
    }
    std::string text = file.dump(2);
    text.erase(text.rfind('\n'));
    return fmt::format("{},\n  \"views\": [\n{}\n  ]\n}}", text, fmt::join(pieces, ",\n"));
}

}  // namespace aoscore
