#include "hand_made.h"

#include "screen/method/depth_layers.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace aoscore::testing {

Scene empty_scene() {
    Scene scene;
    scene.id = "hand-made";
    scene.materials.emplace_back();
    return scene;
}

void add_quad(Scene& scene, const glm::dvec3& origin, const glm::dvec3& a, const glm::dvec3& b,
              int material) {
    Mesh mesh;
    mesh.material = material;
    for (const auto& [s, t] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
        mesh.positions.emplace_back(
            glm::vec3(origin + a * static_cast<double>(s) + b * static_cast<double>(t)));
        mesh.texcoords.emplace_back(static_cast<float>(s), static_cast<float>(t));
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
}

Scene plane_scene(const glm::dvec3& centre, const glm::dvec3& normal, double half_size) {
    const glm::dvec3 other = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 a = glm::normalize(glm::cross(normal, other)), b = glm::cross(normal, a);
    Scene scene = empty_scene();
    add_quad(scene, centre - half_size * (a + b), 2 * half_size * a, 2 * half_size * b);
    return scene;
}

Scene corner_scene() {
    Scene scene = empty_scene();
    add_quad(scene, {-2, 0, -2}, {4, 0, 0}, {0, 0, 4});
    add_quad(scene, {-2, 0, -2}, {3, 0, 0}, {0, 3, 0});
    add_quad(scene, {-2, 0, -2}, {0, 0, 4}, {0, 3, 0});
    const glm::dvec3 o(-0.6, 0.0, -0.9);
    add_quad(scene, o, {0, 0.8, 0}, {0, 0, 0.7});
    add_quad(scene, o + glm::dvec3(0.8, 0, 0), {0, 0.8, 0}, {0, 0, 0.7});
    add_quad(scene, o, {0.8, 0, 0}, {0, 0.8, 0});
    add_quad(scene, o + glm::dvec3(0, 0, 0.7), {0.8, 0, 0}, {0, 0.8, 0});
    add_quad(scene, o + glm::dvec3(0, 0.8, 0), {0.8, 0, 0}, {0, 0, 0.7});
    return scene;
}

Camera front_camera() {
    Camera camera;
    camera.near = 0.1;
    camera.far = 100;
    return camera;
}

Camera corner_camera() {
    Camera camera;
    camera.position = {1.8, 1.9, 2.6};
    camera.target = {-0.4, 0.5, -0.8};
    camera.near = 0.1;
    camera.far = 30;
    return camera;
}

namespace {

std::uint8_t byte_of(float v) {
    return std::isfinite(v) ? static_cast<std::uint8_t>(std::clamp(v, 0.0F, 1.0F) * 255.0F + 0.5F) : 0;
}

float srgb_of(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

void write_bytes(const std::string& path, int width, int height, png_uint_32 format,
                 const std::vector<std::uint8_t>& bytes) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width);
    png.height = static_cast<png_uint_32>(height);
    png.format = format;
    if (png_image_write_to_file(&png, path.c_str(), 0, bytes.data(), 0, nullptr) == 0) {
        throw std::runtime_error("cannot write " + path);
    }
}

}  // namespace

void write_png(const std::string& path, const ImageF& image) {
    std::vector<std::uint8_t> bytes;
    for (const float v : image.pixels) bytes.push_back(byte_of(v));
    write_bytes(path, image.width, image.height, PNG_FORMAT_GRAY, bytes);
}

void write_png(const std::string& path, const Image<glm::vec3>& image) {
    std::vector<std::uint8_t> bytes;
    for (const glm::vec3& colour : image.pixels) {
        for (int channel = 0; channel < 3; ++channel) bytes.push_back(byte_of(srgb_of(colour[channel])));
    }
    write_bytes(path, image.width, image.height, PNG_FORMAT_RGB, bytes);
}

std::vector<std::string> method_ids() {
    std::vector<std::string> ids;
    for (const MethodDescriptor& m : load_methods()) ids.push_back(m.id);
    return ids;
}

std::string test_name(std::string id) {
    std::replace(id.begin(), id.end(), '-', '_');
    return id;
}

MethodRequest request_for(const MethodDescriptor& method, const std::vector<MethodDescriptor>& filters,
                          const std::string& preset, const ParameterValues& overrides) {
    MethodRequest request;
    request.method = &method;
    request.parameters = method.values(preset, overrides);
    const PresetFilter own = method.filter_of(preset);
    if (own.filter != "none") {
        request.filter = &find_method(filters, own.filter);
        request.filter_parameters = request.filter->values(own.preset);
    }
    return request;
}

std::vector<std::string> drawn_presets(const MethodDescriptor& method) {
    std::vector<std::string> drawn;
    for (const auto& [preset, unused] : method.presets) {
        if (!reads_ray_layers(method, method.values(preset))) drawn.push_back(preset);
    }
    return drawn;
}

double mean_over(const ImageF& image, const Mask& mask) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (mask.pixels[i] == 0) continue;
        sum += static_cast<double>(image.pixels[i]);
        ++count;
    }
    return sum / count;
}

}  // namespace aoscore::testing
