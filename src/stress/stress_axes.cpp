#include "stress/stress_axes.h"

#include "scene/builtin/scene_builder.h"
#include "screen/gbuffer/precision.h"
#include "stress/stress_triangles.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace aoscore {
namespace {

using Apply = std::function<void(StressCase&)>;
using Settings = std::vector<StressSetting>;

StressSetting unstressed(std::string label) {
    return {"base", std::move(label), {}};
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

// Makes one setting for each value; `base` is the value of the base case.
Settings over(std::initializer_list<double> values, double base, std::string_view unit,
              const std::function<void(StressCase&, double)>& apply) {
    Settings settings;
    for (const double value : values) {
        const std::string label = fmt::format("{:g}{}", value, unit);
        if (value == base) {
            settings.push_back(unstressed(label));
        } else {
            settings.push_back({fmt::format("{:g}", value), label, [=](StressCase& s) { apply(s, value); }});
        }
    }
    return settings;
}

// Moves near and far plane apart about their middle.
void set_depth_ratio(StressCase& s, double ratio) {
    const double middle = std::sqrt(s.camera.near * s.camera.far);
    s.camera.near = middle / std::sqrt(ratio);
    s.camera.far = middle * std::sqrt(ratio);
}

void place_all(Scene& scene, const glm::dmat4& placed_from_scene) {
    for (Instance& instance : scene.instances)
        instance.scene_from_mesh = placed_from_scene * instance.scene_from_mesh;
}

void scale_all(StressCase& s, double scale) {
    place_all(s.scene, builtin::scaling(scale, scale, scale));
    s.camera.position *= scale;
    s.camera.target *= scale;
    s.camera.near *= scale;
    s.camera.far *= scale;
    s.length_scale = scale;
}

void move_all(StressCase& s, double distance_m) {
    const glm::dvec3 offset = distance_m * glm::normalize(glm::dvec3(2, -1, 2));
    place_all(s.scene, builtin::translation(offset.x, offset.y, offset.z));
    s.camera.position += offset;
    s.camera.target += offset;
}

// Moves the camera on a circle about its target, `tilt_deg` between the line of sight and the floor's normal.
void tilt_view(StressCase& s, double tilt_deg) {
    const double distance = glm::distance(s.camera.position, s.camera.target), t = radians(tilt_deg);
    s.camera.position = s.camera.target + distance * glm::dvec3(0, std::cos(t), std::sin(t));
    s.camera.up = {0, std::sin(t), -std::cos(t)};
}

// Sets the angle of view; the camera comes nearer as it grows, so that the target keeps its size in the
// picture.
void set_field_of_view(StressCase& s, double fovy_deg) {
    const double nearer = std::tan(s.camera.fovy_rad / 2) / std::tan(radians(fovy_deg) / 2);
    s.camera.position = s.camera.target + nearer * (s.camera.position - s.camera.target);
    s.camera.fovy_rad = radians(fovy_deg);
    s.camera.near *= std::min(nearer, 1.0);
    s.camera.far *= std::max(nearer, 1.0);
}

Settings radius_factors() {
    Settings settings = over({1.0 / 256, 1.0 / 64, 1.0 / 16, 0.25, 1, 4, 16, 64, 256}, 1, "",
                             [](StressCase& s, double factor) { s.radius_scale = factor; });
    int part = 256;
    for (std::size_t i = 0; part > 1; ++i, part /= 4) settings[i].label = fmt::format("1/{}", part);
    return settings;
}

Settings depth_formats() {
    Settings settings;
    for (const PrecisionFormat& format : precision_formats()) {
        const std::string label(format.meaning);
        if (format.precision == Precision::full) {
            settings.push_back(unstressed(label));
        } else {
            settings.push_back({std::string(format.id), label,
                                [&format](StressCase& s) { s.modes.precision = format.precision; }});
        }
    }
    return settings;
}

Settings image_sizes() {
    Settings settings;
    const auto add = [&](int width, int height, bool truth, bool performance) {
        const std::string id = fmt::format("{}x{}", width, height);
        settings.push_back({id, id, [=](StressCase& s) {
                                s.width = width;
                                s.height = height;
                                s.has_truth = truth;
                                s.performance_presets_only = performance;
                            }});
    };
    for (const auto& [width, height] :
         {std::pair(1, 1), {2, 1}, {1, 3}, {5, 3}, {1, 257}, {257, 1}, {31, 17}, {127, 129}})
        add(width, height, true, false);
    settings.push_back(unstressed("256x256"));
    add(333, 255, true, false);
    add(1024, 1024, true, false);
    add(4096, 4096, false, true);
    return settings;
}

Settings triangle_kinds() {
    return {
        unstressed("as modelled"),
        {"edges-0.2", "edges up to 0.2 m", [](StressCase& s) { split_to_edges(s.scene, 0.2); }},
        {"sub-pixel", "a quarter of a pixel and less",
         [](StressCase& s) { split_to_edges(s.scene, 0.0225); }},
        {"needles-16", "needles, 16 a triangle",
         [](StressCase& s) { split_to_needles(s.scene, 16, 1 << 17); }},
        {"needles-1024", "needles, up to 1024 a triangle",
         [](StressCase& s) { split_to_needles(s.scene, 1024, 1 << 17); }},
        {"zero-area", "with triangles without area",
         [](StressCase& s) { add_triangles_without_area(s.scene); }},
    };
}

Settings surfaces_again() {
    Settings settings = {
        unstressed("once"),
        {"twice", "every triangle twice", [](StressCase& s) { add_surfaces_again(s.scene, 0, false); }},
        {"twice-split", "again with other triangles",
         [](StressCase& s) { add_surfaces_again(s.scene, 0, true); }},
    };
    for (const double offset_m : {1e-7, 1e-6, 1e-5, 1e-4}) {
        settings.push_back({fmt::format("{:g}", offset_m), fmt::format("again, {:g} m above", offset_m),
                            [=](StressCase& s) { add_surfaces_again(s.scene, offset_m, false); }});
    }
    return settings;
}

constexpr int kBox = 2, kSphere = 3;  // instances of the yard
const glm::dvec3 kBoxCentre(-1.5, 0.5, -1), kSphereCentre(0.6, 0.8, -1.5);

void place_again(Scene& scene, int instance, const glm::dmat4& placed) {
    Instance again = scene.instances[static_cast<std::size_t>(instance)];
    again.scene_from_mesh = placed * again.scene_from_mesh;
    scene.instances.push_back(again);
}

Settings overlaps() {
    const auto sunk = [](double depth_m) {
        return [=](StressCase& s) {
            for (const int solid : {1, kBox})
                place_again(s.scene, solid, builtin::translation(0, -depth_m, 0));
        };
    };
    const auto moved = [](int instance, const glm::dvec3& by) {
        return [=](StressCase& s) { place_again(s.scene, instance, builtin::translation(by.x, by.y, by.z)); };
    };
    return {
        unstressed("apart"),
        {"sunk-0.01", "solids again, 0.01 m lower", sunk(0.01)},
        {"sunk-0.5", "solids again, 0.5 m lower", sunk(0.5)},
        {"sphere-in-box", "a sphere through the box's faces",
         moved(kSphere, kBoxCentre + glm::dvec3(0.2, 0.1, 0.2) - kSphereCentre)},
        {"sphere-in-floor", "a sphere half in the floor", moved(kSphere, {-0.6, -0.8, 2.5})},
        {"box-in-wall", "a turned box through wall and floor",
         [](StressCase& s) {
             place_again(s.scene, kBox,
                         builtin::translation(0.6, 0.3, -3) * builtin::rotation_x(0.6) *
                             builtin::rotation_y(0.5) *
                             builtin::translation(-kBoxCentre.x, -kBoxCentre.y, -kBoxCentre.z));
         }},
    };
}

void look(Camera& camera, const glm::dvec3& position, const glm::dvec3& direction) {
    camera.position = position;
    camera.target = position + direction;
}

Settings empty_views() {
    return {
        unstressed("full"),
        {"sky", "only sky",
         [](StressCase& s) {
             look(s.camera, s.camera.position, {0, 1, 0.1});
         }},
        {"behind", "everything nearer than the near plane", [](StressCase& s) { s.camera.near = 150; }},
        {"beyond", "everything beyond the far plane", [](StressCase& s) { s.camera.far = 0.3; }},
        {"no-triangles", "no triangle in the scene", [](StressCase& s) { s.scene.instances.clear(); }},
        {"speck", "one triangle as large as a pixel or two",
         [](StressCase& s) {
             s.scene.instances.resize(1);
             Mesh& mesh = s.scene.meshes[0];
             mesh.triangles.resize(1);
             mesh.normals.clear();
             mesh.positions = {{-0.02F, 0, -0.03F}, {0.02F, 0, -0.03F}, {0, 0, 0.03F}};
             mesh.triangles = {{0, 1, 2}};
         }},
    };
}

Settings eye_places() {
    const auto at = [](const glm::dvec3& position, const glm::dvec3& direction, double near_m) {
        return [=](StressCase& s) {
            look(s.camera, position, direction);
            s.camera.near = near_m;
        };
    };
    const glm::dvec3 ahead(0.3, -0.2, 1);
    return {
        unstressed("outside"),
        {"box", "in the box", at(kBoxCentre, ahead, 0.2)},
        {"sphere", "in the sphere", at(kSphereCentre, ahead, 0.2)},
        {"cut", "in the box, its front cut by the near plane", at(kBoxCentre, ahead, 0.45)},
        {"clipped", "in the box, all of it before the near plane", at(kBoxCentre, ahead, 1)},
        {"on-floor", "on the floor's plane", at({0, 0, 5}, {0, 0, -1}, 0.2)},
        {"below", "below the floor", at({0, -2, 3}, {0, 0.4, -1}, 0.2)},
    };
}

std::vector<StressAxis> make_axes() {
    constexpr auto kSame = StressJudgement::same_picture;
    constexpr auto kError = StressJudgement::error;
    const std::initializer_list<double> ratios = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
    return {
        {"depth-ratio", "Near to far", "Far over near plane, linear depth in floats.", kSame,
         over(ratios, 1e3, "", set_depth_ratio)},
        {"depth-ratio-24", "Near to far, 24 bits",
         "Far over near plane, from a window depth of 24 bits; the base has linear depth in floats.", kSame,
         [&] {
             Settings settings = over(ratios, 0, "", [](StressCase& s, double ratio) {
                 set_depth_ratio(s, ratio);
                 s.modes.precision = Precision::depth_24;
             });
             settings.insert(settings.begin(), unstressed("1000, floats"));
             return settings;
         }()},
        {"depth-format", "Depth format", "How depth and normals are stored; far over near plane is 1000.",
         kSame, depth_formats()},
        {"scale", "Scene scale", "Scene, camera and every length among the parameters times a factor.", kSame,
         over({1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5}, 1, "", scale_all)},
        {"offset", "Distance from the origin", "Scene and camera moved away from the world's zero.", kSame,
         over({0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}, 0, " m", move_all)},
        {"triangles", "Triangles", "The same surfaces cut into other triangles.", kSame, triangle_kinds()},
        {"coplanar", "Coplanar surfaces", "Every surface a second time, at or just above its place.", kSame,
         surfaces_again()},
        {"overlap", "Interpenetration", "Solids that reach through each other.", kError, overlaps()},
        {"tilt", "Tilt", "Angle between the line of sight and the floor's normal.", kError,
         over({0, 30, 60, 75, 80, 85, 88, 89, 89.5, 89.9}, 60, "°", tilt_view)},
        {"fov", "Field of view", "Vertical angle; the camera moves so that the middle keeps its size.",
         kError, over({1, 5, 20, 50, 90, 120, 150, 160, 170}, 50, "°", set_field_of_view)},
        {"radius", "Radius",
         "The methods' radius times a factor: at 1/16 about a pixel, at 16 more than the picture.", kError,
         radius_factors()},
        {"size", "Image size", "Width x height; 4096x4096 without truth and for performance presets alone.",
         kError, image_sizes()},
        {"empty", "Empty views", "Nothing, or next to nothing, in the picture.", kError, empty_views()},
        {"inside", "Camera inside", "The camera within a solid, or on a surface.", kError, eye_places()},
    };
}

}  // namespace

const std::vector<StressAxis>& stress_axes() {
    static const std::vector<StressAxis> axes = make_axes();
    return axes;
}

StressCase stress_case(const StressSetting& setting, int size) {
    StressCase stress = base_stress_case(size);
    if (setting.apply) setting.apply(stress);
    finish_stress_case(stress);
    return stress;
}

}  // namespace aoscore
