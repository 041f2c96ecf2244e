#include "screen/method/layer_bytes.h"

#include "screen/method/depth_layers.h"
#include "screen/method/side_layers.h"

namespace aoscore {
namespace {

std::size_t bytes_of(int samples, int width, int height) {
    return static_cast<std::size_t>(stored_depths(samples)) * sizeof(float) *
           static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

std::optional<std::size_t> layer_bytes(const MethodRequest& request, int width, int height) {
    const MethodDescriptor& method = *request.method;
    if (!method.depth_layers && !method.side_layers) return std::nullopt;
    const glm::ivec2 band_px = request.guard_band.pixels(width, height);
    width += 2 * band_px.x;
    height += 2 * band_px.y;
    std::size_t bytes = 0;
    if (method.depth_layers) {
        const DepthLayers layers = asked_depth_layers(*method.depth_layers, request.parameters, request.seed);
        bytes += bytes_of(layers.samples, width, height);
    }
    if (method.side_layers) {
        const SideLayers side = asked_side_layers(*method.side_layers, request.parameters, request.seed);
        bytes += static_cast<std::size_t>(side.cameras) * bytes_of(side.layers.samples,
                                                                   (width + side.scale - 1) / side.scale,
                                                                   (height + side.scale - 1) / side.scale);
    }
    return bytes;
}

}  // namespace aoscore
