#include "bench/bench_layers.h"

#include "core/output.h"
#include "core/processor_watch.h"
#include "jobs/timing.h"
#include "plan/ranking_radius.h"
#include "screen/method/depth_layers.h"
#include "screen/method/lengths.h"
#include "screen/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace aoscore {
namespace {

constexpr std::array kSampleCounts = {1, 2, 4, 8, 16};
constexpr int kLayerRounds = 5, kSeeds = 4;
constexpr int kTimedWidth = 1920, kTimedHeight = 1080, kSeenWidth = 640, kSeenHeight = 360;

double processor_ms(const std::function<void()>& work) {
    const ProcessorWatch watch;
    work();
    return watch.milliseconds();
}

// A first drawing compiles, where Mesa keeps no program of an earlier run.
void add_cost(ScreenRenderer& renderer, const DepthLayers& layers, RatioTable& table) {
    constexpr const char* kUnit = "processor ms";
    const double first_ms = processor_ms([&] { renderer.draw_depth_layers(layers); });
    std::vector<double> layers_ms, plain_ms;
    for (int round = 0; round < kLayerRounds; ++round) {
        layers_ms.push_back(processor_ms([&] { renderer.draw_depth_layers(layers); }));
        plain_ms.push_back(layers.samples * processor_ms([&] { renderer.time_gbuffer(); }));
    }
    const std::string name = fmt::format("{} {} depth layers", layers.samples, layers.sampling);
    const std::string plain = fmt::format("{} x plain depth, beside {}", layers.samples, layers.sampling);
    table.add(plain, *summarize(plain_ms).median_ms, kUnit);
    table.add(name, *summarize(layers_ms).median_ms, kUnit, plain);
    table.add(name + ", first time", first_ms, kUnit);
}

void add_costs(ScreenRenderer& renderer, const View& view, RatioTable& table) {
    renderer.draw_gbuffer(CameraFrame(view.camera, kTimedWidth, kTimedHeight), {});
    for (const DepthSampling& sampling : depth_samplings()) {
        if (!sampling.tosses_coins) continue;
        for (const int samples : kSampleCounts) {
            DepthLayers layers;
            layers.samples = samples;
            layers.alpha = 0.2;
            layers.sampling = sampling.id;
            add_cost(renderer, layers, table);
        }
    }
    for (const int samples : kSampleCounts) {
        table.add(fmt::format("{} depth layers, memory", samples),
                  1e-6 * kTimedWidth * kTimedHeight * samples * sizeof(float), "MB");
    }
}

/// A method's occlusion over one layer, and over all that are peeled off.
struct Hidden {
    ImageF first, all;

    bool is_hidden(std::size_t i) const { return all.pixels[i] - first.pixels[i] > 0.02F; }
    bool is_visible(std::size_t i) const {
        return first.pixels[i] > 0.02F && std::abs(all.pixels[i] - first.pixels[i]) < 1e-4F;
    }
};

class LayeredMethod {
  public:
    LayeredMethod(ScreenRenderer& renderer, const MethodDescriptor& method, double radius_m)
        : renderer_(&renderer), method_(&method), values_(values_for_radius(method, radius_m, "default")) {}

    ImageF occlusion(const ParameterValues& settings, std::uint64_t seed) const {
        MethodRequest request;
        request.method = method_;
        request.parameters = values_;
        for (const auto& [id, value] : settings) request.parameters[id] = value;
        request.seed = seed;
        ImageF image = renderer_->run(request).raw;
        for (float& v : image.pixels) v = 1 - v;
        return image;
    }
    Hidden hidden(std::uint64_t seed) const {
        return {occlusion(first_layer_alone(*method_).value(), seed),
                occlusion(all_layers(*method_).value(), seed)};
    }

  private:
    ScreenRenderer* renderer_;
    const MethodDescriptor* method_;
    ParameterValues values_;
};

/// Mean and variance of a pixel's occlusion over the coins' seeds.
struct OverSeeds {
    std::vector<double> mean, variance;
};

OverSeeds over_seeds(const LayeredMethod& method, int samples, std::uint64_t seed) {
    OverSeeds result;
    for (int i = 1; i <= kSeeds; ++i) {
        const ImageF image = method.occlusion({{"depth_samples", samples}, {"coin_seed", i}}, seed);
        result.mean.resize(image.size());
        result.variance.resize(image.size());
        for (std::size_t p = 0; p < image.size(); ++p) {
            const double value(image.pixels[p]);
            result.mean[p] += value / kSeeds;
            result.variance[p] += value * value / kSeeds;
        }
    }
    for (std::size_t p = 0; p < result.mean.size(); ++p) {
        const double squares = result.variance[p] - result.mean[p] * result.mean[p];
        result.variance[p] = std::max(squares, 0.0) * kSeeds / (kSeeds - 1);
    }
    return result;
}

/// What is found again of the hidden occlusion at a strength, as a part of it.
double recovered(const Hidden& hidden, const std::vector<double>& occlusion, double strength) {
    double found = 0, whole = 0;
    for (std::size_t i = 0; i < occlusion.size(); ++i) {
        if (!hidden.is_hidden(i)) continue;
        found += std::min(strength * occlusion[i], 1.0) - static_cast<double>(hidden.first.pixels[i]);
        whole += static_cast<double>(hidden.all.pixels[i] - hidden.first.pixels[i]);
    }
    return found / whole;
}

void print_recovery(const std::string& id, const LayeredMethod& method, std::uint64_t seed) {
    const Hidden hidden = method.hidden(seed);
    std::size_t hidden_pixels = 0;
    for (std::size_t i = 0; i < hidden.first.size(); ++i) hidden_pixels += hidden.is_hidden(i) ? 1 : 0;
    if (hidden_pixels == 0) {
        print_result("{:<14} finds nothing behind the first layer of this view\n", id);
        return;
    }
    for (const int samples : kSampleCounts) {
        const OverSeeds sampled = over_seeds(method, samples, seed);
        double kept = 0, whole = 0, variance = 0;
        for (std::size_t i = 0; i < sampled.mean.size(); ++i) {
            variance += sampled.variance[i] / static_cast<double>(sampled.mean.size());
            if (!hidden.is_visible(i)) continue;
            kept += sampled.mean[i];
            whole += static_cast<double>(hidden.first.pixels[i]);
        }
        print_result("{:<14} {:>3} {:>10} {:>10.3f} {:>10.3f} {:>12.3f} {:>14.3f} {:>9.4f}\n", id, samples,
                     hidden_pixels, kept / whole, recovered(hidden, sampled.mean, 1), whole / kept,
                     recovered(hidden, sampled.mean, whole / kept), std::sqrt(variance));
    }
}

}  // namespace

void bench_layers(const Scene& scene, const View& view, std::uint64_t seed, RatioTable& table) {
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    const double radius_m = ranking_radius({}, view, scene).metres;
    print_result("{}/{}, {}\n", scene.id, view.id, renderer.renderer());
    print_result("costs at {}x{}\n", kTimedWidth, kTimedHeight);
    add_costs(renderer, view, table);
    renderer.draw_gbuffer(CameraFrame(view.camera, kSeenWidth, kSeenHeight), gbuffer_inputs());
    print_result("{}x{}, R {:g} m, without a filter, mean over {} seeds of the coins\n", kSeenWidth,
                 kSeenHeight, radius_m, kSeeds);
    print_result("{:<14} {:>3} {:>10} {:>10} {:>10} {:>12} {:>14} {:>9}\n", "method", "S", "pixels", "kept",
                 "recovered", "strength", "recovered then", "noise");
    for (const MethodDescriptor& method : load_methods()) {
        if (method.depth_layers) print_recovery(method.id, LayeredMethod(renderer, method, radius_m), seed);
    }
}

}  // namespace aoscore
