#include "jobs/recorded/frame_file.h"

#include "core/error.h"
#include "image/frame_layout.h"
#include "image/image_frame.h"
#include "jobs/recorded/frame_camera.h"
#include "jobs/recorded/frame_depth.h"
#include "jobs/recorded/frame_normals.h"
#include "jobs/truth_channels.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace aoscore {
namespace {

FrameCamera camera_of(const FrameRequest& request, const ImageFile& file, const std::string& where) {
    if (!request.camera.empty())
        return read_frame_camera(request.camera, static_cast<double>(file.width) / file.height);
    if (auto camera = frame_camera_of_header(file.attributes, where)) return *camera;
    throw file_error("states no projection", where,
                     "--camera FILE.json with fovy_deg (or fovx_deg, or half_height_m), and near_m and far_m "
                     "where depth is a depth buffer's");
}

/// Background where the file's own mask says so.
void mask_out(const ImageFile& file, FrameDepth& depth) {
    const ImageF* mask = file.channel(std::string(kMaskChannel));
    if (mask == nullptr) return;
    for (std::size_t i = 0; i < mask->size(); ++i) {
        if (mask->pixels[i] > 0.5F) continue;
        depth.surface.pixels[i] = 0;
        depth.view_depth.pixels[i] = static_cast<float>(depth.frame.camera().far);
        depth.window_depth.pixels[i] = 1;
    }
}

Image<glm::vec3> normals_from_depth(const CameraFrame& frame, const GBufferImages& images) {
    ScreenRenderer renderer;
    renderer.take_gbuffer(frame, images, {});
    return renderer.read_normals_from_depth();
}

void add_albedo(const ImageFile& file, const FrameLayout& layout, GBufferImages& images) {
    const auto first = find_channel(layout, layout.albedo, file);
    const auto channels = first ? three_channels(*first, file) : std::nullopt;
    if (!channels) return;
    Image<glm::vec3> albedo(file.width, file.height);
    for (std::size_t i = 0; i < albedo.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            albedo.pixels[i][axis] = file.channels[(*channels)[static_cast<std::size_t>(axis)]].pixels[i];
    }
    images.vectors["albedo"] = std::move(albedo);
}

}  // namespace

FrameFile read_frame(const FrameRequest& request) {
    const ImageFile file = read_frame_files(request.files);
    const std::string where = request.files.front().string();
    const FrameLayout& layout = layout_of(file, request.layout, where);
    const FrameCamera camera = camera_of(request, file, where);
    const std::size_t channel = *find_channel(layout, layout.depth, file);
    const std::string& name = file.channel_names[channel];
    require_whole_frame(file, channel, where + ": " + name);
    const DepthKind kind = camera.depth.value_or(layout.depth_kind);
    FrameDepth depth =
        frame_depth(file.channels[channel], kind, layout.background_from, camera, where + ": " + name);
    mask_out(file, depth);
    FrameFile result{depth.frame, {}, fmt::format("layout {}: depth {}", layout.id, name), file.doubts};
    for (const DepthKindName& row : depth_kinds()) {
        if (row.kind == kind) result.read_as += fmt::format(" ({})", row.id);
    }
    GBufferImages& images = result.images;
    images.surface = std::move(depth.surface);
    images.numbers["linear_depth"] = std::move(depth.view_depth);
    images.numbers["hardware_depth"] = std::move(depth.window_depth);
    // Window depth of the rasteriser itself is kept to the bit.
    if (const ImageF* window = file.channel("depth.Z"); layout.turned && window != nullptr)
        images.numbers["hardware_depth"] = *window;
    add_albedo(file, layout, images);
    add_normals(file, layout, camera, normals_from_depth(result.frame, images), where, images, result.read_as,
                result.warnings);
    return result;
}

}  // namespace aoscore
