#include "experiment/view_description.h"

#include <glm/glm.hpp>

namespace aoscore {
namespace {

std::vector<double> numbers(const glm::dvec3& v) {
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
    record.position_m = numbers(camera.position + scene.origin);
    record.target_m = numbers(camera.target + scene.origin);
    record.up = numbers(camera.up);
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

}  // namespace aoscore
