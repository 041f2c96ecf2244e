#include "reference/ray_layers.h"

#include "core/interrupt.h"
#include "core/sampling.h"
#include "core/threads.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/tracer/scene_builds.h"
#include "reference/truth.h"
#include "reference/truth_impl.h"

#include <limits>

namespace aoscore {
namespace {

/// A ray goes on so far behind a surface, in parts of its depth: beyond the rounding of the depth.
constexpr double kBeyond = 4e-6;

/// A number in [0, count).
std::size_t drawn_below(std::size_t count, std::uint64_t bits) {
    return static_cast<std::size_t>((mix_bits(bits) >> 32) * count >> 32);
}

struct PixelLayers {
    const RayTracer& tracer;
    const CameraFrame& frame;
    const RayLayers& wanted;

    /// Fills the depths of a pixel; those that stay empty keep their value.
    void gather(int x, int y, std::vector<ImageF>& layers) const {
        const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
        SurfaceHit hit;
        const double far = frame.camera().far;
        if (!tracer.first_hit(ray, frame.camera().near, far, hit)) return;
        layers[0].at(x, y) = static_cast<float>(hit.depth);
        const double end = wanted.reach_m > 0 ? std::min(hit.depth + wanted.reach_m, far) : far;
        const std::size_t room = layers.size() - 1;
        const std::uint64_t pixel = layers[0].index(x, y);
        for (int behind = 0; room > 0 && behind < wanted.most_behind; ++behind) {
            if (!tracer.first_hit(ray, hit.depth * (1 + kBeyond), end, hit)) return;
            const auto count = static_cast<std::size_t>(behind) + 1;
            const std::uint64_t coin =
                mix_bits(pixel << 8 | static_cast<std::uint64_t>(behind)) ^ wanted.seed;
            const std::size_t place = count <= room ? count - 1 : drawn_below(count, coin);
            if (place < room) layers[place + 1].at(x, y) = static_cast<float>(hit.depth);
        }
    }
};

}  // namespace

std::vector<ImageF> ReferenceScene::ray_layers(const CameraFrame& frame, const RayLayers& wanted) const {
    // What lies behind is not what the camera sees, so that no part of the scene can be left out.
    const ReachableScene scene = impl_->builds.reachable(frame, std::numeric_limits<double>::infinity());
    const ImageF empty(frame.width(), frame.height(), static_cast<float>(frame.camera().far));
    std::vector<ImageF> layers(static_cast<std::size_t>(wanted.samples), empty);
    const PixelLayers pixels{scene.tracer, frame, wanted};
    parallel_for(static_cast<std::size_t>(frame.height()), [&](std::size_t row) {
        throw_if_interrupted();
        for (int x = 0; x < frame.width(); ++x) pixels.gather(x, static_cast<int>(row), layers);
    });
    return layers;
}

}  // namespace aoscore
