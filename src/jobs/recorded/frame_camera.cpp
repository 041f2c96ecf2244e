#include "jobs/recorded/frame_camera.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/strict_json.h"
#include "scene/scene_frame.h"

#include <charconv>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

constexpr double kMostAngle_deg = 179.9, kLeastAngle_deg = 0.01, kMost_m = 1e9, kLeast_m = 1e-9;

double half_tangent(double degrees) {
    return std::tan(glm::radians(degrees) / 2);
}

void read_projection(StrictObject& object, double aspect, Camera& camera) {
    const std::string projection = object.text_or("projection", "perspective");
    if (projection == "orthographic") {
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = object.number("half_height_m", kLeast_m, kMost_m);
    } else if (projection != "perspective") {
        throw unknown_name_in_file(projection, {"perspective", "orthographic"}, object.where("projection"));
    } else if (object.has("fovx_deg")) {
        const double across = half_tangent(object.number("fovx_deg", kLeastAngle_deg, kMostAngle_deg));
        camera.fovy_rad = 2 * std::atan(across / aspect);
    } else {
        camera.fovy_rad = glm::radians(object.number("fovy_deg", kLeastAngle_deg, kMostAngle_deg));
    }
}

/// The rotation of a 4x4 matrix, row by row for column vectors. Throws file_error where it is none.
glm::dmat3 read_rotation(StrictObject& object) {
    const std::vector<double> m = object.numbers("world_to_camera", 16);
    glm::dmat3 rotation;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            rotation[column][row] = m[static_cast<std::size_t>(4 * row + column)];
    }
    const double determinant = glm::determinant(rotation);
    if (determinant < 0)
        throw file_error("mirrors what it turns, as the matrix of a camera does that looks down +z",
                         object.where("world_to_camera"),
                         "the same with its third row negated, to a camera that looks down -z with y up");
    const double scale = std::cbrt(determinant);
    rotation /= scale > 0 ? scale : 1;
    const glm::dmat3 product = glm::transpose(rotation) * rotation;
    for (int i = 0; i < 3; ++i) {
        if (!(glm::length(product[i] - glm::dmat3(1.0)[i]) < 1e-3))
            throw file_error("is no rotation with a translation", object.where("world_to_camera"),
                             "16 numbers, row by row, to a camera that looks down -z with y up");
    }
    return rotation;
}

/// The far plane; a text in its place says that there is none.
void read_planes(StrictObject& object, FrameCamera& result) {
    Camera& camera = result.camera;
    camera.near = object.number("near_m", kLeast_m, kMost_m);
    result.infinite_far = object.has("far_m") && object.raw("far_m").is_string();
    if (!result.infinite_far) {
        camera.far = object.number("far_m", camera.near, kMost_m);
        if (camera.far <= camera.near)
            throw file_error("is the near plane", object.where("far_m"), "a larger distance");
        return;
    }
    if (object.text("far_m") != "infinite" || camera.projection == Camera::Projection::orthographic)
        throw file_error("is no far plane", object.where("far_m"),
                         "a number of metres; \"infinite\" for a perspective camera without a far plane");
    camera.far = 2 * camera.near;  // until the depths are known
}

/// Signs of the three axes.
glm::dvec3 read_signs(StrictObject& object) {
    const std::vector<double> signs = object.numbers("normal_signs", 3);
    for (const double sign : signs) {
        if (std::abs(sign) != 1)
            throw file_error("holds no sign", object.where("normal_signs"), "1 or -1, three of them");
    }
    return {signs[0], signs[1], signs[2]};
}

double header_number(const std::map<std::string, std::string>& attributes, const std::string& name,
                     const std::string& where) {
    const auto found = attributes.find(name);
    double value = 0;
    if (found != attributes.end()) {
        const std::string& text = found->second;
        const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (ec == std::errc() && end == text.data() + text.size() && value > 0 && std::isfinite(value))
            return value;
    }
    throw file_error("states no number above 0", where + ": " + name,
                     "the header that aoscore gbuffer wrote");
}

}  // namespace

FrameCamera read_frame_camera(const std::filesystem::path& path, double aspect) {
    const nlohmann::json json = parse_json_file(path);
    StrictObject object = StrictObject::of_file(json, path.string());
    FrameCamera result;
    read_projection(object, aspect, result.camera);
    result.has_planes = object.has("near_m") || object.has("far_m");
    if (result.has_planes) read_planes(object, result);
    if (object.has("normal_signs")) result.normal_signs = read_signs(object);
    if (object.has("depth"))
        result.depth = row_in_file(depth_kinds(), object.text("depth"), object.where("depth")).kind;
    if (object.has("unit")) {
        const std::optional<double> metres = parse_unit(object.text("unit"));
        if (!metres)
            throw file_error("is no unit", object.where("unit"),
                             "m, cm, mm, in, ft, km, or metres as a text");
        result.metres_per_unit = *metres;
    }
    if (object.has("normals")) {
        const std::string space = object.text("normals");
        if (space != "world" && space != "view")
            throw unknown_name_in_file(space, {"view", "world"}, object.where("normals"));
        result.world_normals = space == "world";
    }
    if (object.has("world_to_camera")) result.view_from_world = read_rotation(object);
    object.finish();
    return result;
}

std::optional<FrameCamera> frame_camera_of_header(const std::map<std::string, std::string>& attributes,
                                                  const std::string& where) {
    const auto projection = attributes.find("aoscore:projection");
    if (projection == attributes.end()) return std::nullopt;
    FrameCamera result;
    Camera& camera = result.camera;
    camera.near = header_number(attributes, "aoscore:near_m", where);
    camera.far = header_number(attributes, "aoscore:far_m", where);
    if (projection->second == "orthographic") {
        camera.projection = Camera::Projection::orthographic;
        camera.half_height = header_number(attributes, "aoscore:half_height_m", where);
    } else {
        camera.fovy_rad = glm::radians(header_number(attributes, "aoscore:fovy_deg", where));
    }
    return result;
}

}  // namespace aoscore
