#include "reference/benchmark/growth.h"

#include "reference/benchmark/processor_time.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

/// Every triangle cut into four at the middles of its edges.
Scene refined(Scene scene) {
    for (Mesh& mesh : scene.meshes) {
        Mesh fine;
        fine.material = mesh.material;
        for (const glm::uvec3& t : mesh.triangles) {
            const auto first = static_cast<unsigned>(fine.positions.size());
            const auto add = [&](unsigned i, unsigned j) {
                fine.positions.push_back((mesh.positions[i] + mesh.positions[j]) * 0.5f);
                if (!mesh.texcoords.empty())
                    fine.texcoords.push_back((mesh.texcoords[i] + mesh.texcoords[j]) * 0.5f);
                if (!mesh.alphas.empty()) fine.alphas.push_back((mesh.alphas[i] + mesh.alphas[j]) * 0.5f);
            };
            add(t.x, t.x), add(t.y, t.y), add(t.z, t.z), add(t.x, t.y), add(t.y, t.z), add(t.z, t.x);
            for (const glm::uvec3& part :
                 {glm::uvec3(0, 3, 5), glm::uvec3(3, 1, 4), glm::uvec3(5, 4, 2), glm::uvec3(3, 4, 5)}) {
                fine.triangles.push_back(part + first);
            }
        }
        mesh = std::move(fine);
    }
    return scene;
}

}  // namespace

void print_growth(const Scene& scene, const ReferenceScene& reference, const Camera& camera,
                  const ReferenceBenchmark& benchmark) {
    const double radius_m = benchmark.radii_m.front();
    const std::vector<TruthQuery> query = {{Falloff::binary, radius_m, 0}};
    TruthSettings settings;
    settings.samples = 64;
    fmt::print("Growth with pixels, 64 samples, R {} m:", radius_m);
    for (const int part : {4, 2, 1}) {
        const CameraFrame frame(camera, benchmark.width / part, benchmark.height / part);
        const double seconds = seconds_of([&] { reference.trace(frame, query, settings, "growth"); });
        fmt::print(" {}x{} {:.2f} s ({:.2f} us a pixel)", frame.width(), frame.height(), seconds,
                   seconds * 1e6 / frame.width() / frame.height());
    }
    fmt::print("\nGrowth with triangles, 64 samples, R {} m:", radius_m);
    const CameraFrame frame(camera, benchmark.width / 2, benchmark.height / 2);
    Scene fine = scene;
    std::size_t triangles = 0;
    std::vector<double> times;
    for (const Instance& i : scene.instances)
        triangles += scene.meshes[static_cast<std::size_t>(i.mesh)].triangles.size();
    for (int level = 0; level < 3; ++level, triangles *= 4) {
        if (level > 0) fine = refined(std::move(fine));
        const ReferenceScene finer(fine, TraceBuild{100'000'000});
        const double seconds = seconds_of([&] { finer.trace(frame, query, settings, "growth"); });
        fmt::print(" {} {:.2f} s", triangles, seconds);
        std::fflush(stdout);
        times.push_back(seconds);
    }
    // Between four and sixteen times as many, by the power law through both.
    const double tenfold = times[1] * std::pow(times[2] / times[1], std::log(10.0 / 4) / std::log(16.0 / 4));
    fmt::print("; tenfold (interpolated): {:.2f} times as long\n", tenfold / times[0]);
}

}  // namespace aoscore
