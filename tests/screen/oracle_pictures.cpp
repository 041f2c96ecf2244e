#include "oracle_pictures.h"

#include "hand_made.h"

#include <utility>

namespace aoscore::testing {

Scene height_field_scene(const std::function<double(double, double)>& z, double footprint_m) {
    constexpr int kCells = 2 * formula::kSize + 80;
    const double extent = kCells * footprint_m / 4;
    Scene scene = empty_scene();
    Mesh mesh;
    for (int j = 0; j <= kCells; ++j) {
        for (int i = 0; i <= kCells; ++i) {
            const double x = -extent + i * footprint_m / 2, y = -extent + j * footprint_m / 2;
            mesh.positions.emplace_back(x, y, z(x, y));
        }
    }
    const auto at = [](int i, int j) { return static_cast<unsigned>(j * (kCells + 1) + i); };
    for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    scene.meshes.push_back(std::move(mesh));
    scene.instances.emplace_back();
    return scene;
}

CameraFrame oracle_frame(double footprint_m) {
    Camera camera = front_camera();
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = formula::kSize * footprint_m / 2;
    return CameraFrame(camera, formula::kSize, formula::kSize);
}

ImageF mean_over_seeds(ScreenRenderer& renderer, const std::vector<MethodDescriptor>& methods,
                       const formula::Case& c, Precision precision) {
    MethodRequest request;
    request.method = &find_method(methods, c.method);
    request.parameters = request.method->values("default", c.settings);
    request.uniform_form = c.seeds > 1;
    request.precision = precision;
    ImageF mean(formula::kSize, formula::kSize, 0);
    for (request.seed = 1; request.seed <= static_cast<std::uint64_t>(c.seeds); ++request.seed) {
        const ImageF once = renderer.run(request).raw;
        for (std::size_t i = 0; i < once.size(); ++i)
            mean.pixels[i] += once.pixels[i] / static_cast<float>(c.seeds);
    }
    return mean;
}

oracle::Point point_at(const CameraFrame& frame, const GBufferImages& images, int x, int y) {
    oracle::Point point;
    point.p = frame.view_position(x + 0.5, y + 0.5, static_cast<double>(images.linear_depth().at(x, y)));
    point.n = glm::normalize(glm::dvec3(images.vector("normal_geometric").at(x, y)));
    return point;
}

}  // namespace aoscore::testing
