#include "jobs/image_output.h"

#include "core/files.h"
#include "image/channels.h"
#include "image/image_file.h"
#include "image/surface_channels.h"
#include "jobs/own_truth.h"
#include "jobs/truth_channels.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <list>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

ImageF as_float(const Mask& mask) {
    ImageF image(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.size(); ++i) image.pixels[i] = mask.pixels[i] != 0 ? 1.0f : 0.0f;
    return image;
}

ImageF component(const Image<glm::vec3>& image, int axis) {
    ImageF result(image.width, image.height);
    for (std::size_t i = 0; i < image.size(); ++i) result.pixels[i] = image.pixels[i][axis];
    return result;
}

template <class Names>
void add_vectors(const Image<glm::vec3>& image, const Names& names, std::vector<ChannelView>& channels,
                 std::list<ImageF>& planes) {
    if (image.empty()) return;
    for (int axis = 0; axis < 3; ++axis) {
        planes.push_back(component(image, axis));
        channels.push_back({std::string(names[static_cast<std::size_t>(axis)]), &planes.back()});
    }
}

/// A matrix as EXR's attributes store it: 16 numbers, row by row, for points that are row vectors.
std::string row_vector_matrix(const glm::dmat4& matrix) {
    std::string text;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            text += fmt::format("{}{}", text.empty() ? "" : " ", matrix[column][row]);
    }
    return text;
}

}  // namespace

void write_truth(const std::filesystem::path& path, const Truth& truth, const Mask& valid,
                 std::map<std::string, std::string> attributes) {
    const ImageF mask = as_float(valid);
    std::vector<ChannelView> channels{{std::string(kMaskChannel), &mask}};
    std::list<ImageF> planes;  // a list: its elements stay where they are
    for (const TruthChannel& channel : truth_channels()) {
        if (channel.number && channel.held_by(truth))
            channels.push_back({channel.exr_names[0], &channel.number(truth)});
        if (channel.direction) add_vectors(channel.direction(truth), channel.exr_names, channels, planes);
    }
    for (std::size_t q = 0; q < truth.queries.size(); ++q) {
        const TruthQuery& query = truth.queries[q];
        channels.push_back({query_channel(q), &truth.visibility[q]});
        if (!truth.standard_error[q].empty())
            channels.push_back({query_error_channel(q), &truth.standard_error[q]});
        const std::string id = fmt::format("V{}", q);
        attributes["aoscore:" + id + ".falloff"] = falloff_name(query.falloff);
        attributes["aoscore:" + id + ".radius_m"] =
            std::isfinite(query.radius_m) ? fmt::format("{}", query.radius_m) : "infinite";
        if (query.falloff == Falloff::alchemy)
            attributes["aoscore:" + id + ".u_m"] = fmt::format("{}", query.u_m);
    }
    attributes["aoscore:samples"] = fmt::format("{}", truth.samples);
    write_exr(path, channels, attributes);
}

Image<glm::vec3> view_positions(const GBufferImages& gbuffer, const CameraFrame& frame) {
    Image<glm::vec3> result(frame.width(), frame.height());
    const ImageF& depth_m = gbuffer.linear_depth();
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            if (gbuffer.surface.at(x, y) == 0) continue;
            result.at(x, y) = frame.view_position(x + 0.5, y + 0.5, static_cast<double>(depth_m.at(x, y)));
        }
    }
    return result;
}

std::map<std::string, std::string> camera_attributes(const CameraFrame& frame, const glm::dvec3& origin) {
    const glm::dmat4 view_from_world = glm::translate(frame.view_from_world(), -origin);
    const Camera& camera = frame.camera();
    const bool perspective = camera.projection == Camera::Projection::perspective;
    return {{"worldToCamera", row_vector_matrix(view_from_world)},
            {"worldToNDC", row_vector_matrix(frame.clip_from_view() * view_from_world)},
            {"aoscore:view_space", "metres, right-handed, looking down -z"},
            {"aoscore:projection", perspective ? "perspective" : "orthographic"},
            perspective ? std::pair("aoscore:fovy_deg", fmt::format("{}", glm::degrees(camera.fovy_rad)))
                        : std::pair("aoscore:half_height_m", fmt::format("{}", camera.half_height)),
            {"aoscore:near_m", fmt::format("{}", camera.near)},
            {"aoscore:far_m", fmt::format("{}", camera.far)}};
}

std::map<std::string, std::string> gbuffer_attributes(const Scene& scene, const std::string& view,
                                                      const CameraFrame& frame, const std::string& renderer,
                                                      const std::string& command) {
    std::map<std::string, std::string> attributes = camera_attributes(frame, scene.origin);
    attributes.merge(std::map<std::string, std::string>{{"aoscore:scene", scene.id},
                                                        {"aoscore:scene_digest", scene.digest},
                                                        {"aoscore:view", view},
                                                        {"aoscore:gl_renderer", renderer},
                                                        {"aoscore:version", std::string(version())},
                                                        {"comments", command}});
    return attributes;
}

void write_gbuffer(const std::filesystem::path& path, const GBufferImages& gbuffer,
                   const Image<glm::vec3>& positions_m, const std::map<std::string, std::string>& attributes,
                   std::span<const SurfaceLayer> surfaces) {
    const ImageF mask = as_float(gbuffer.surface);
    std::vector<ChannelView> channels{{"Y", &gbuffer.linear_depth()}, {std::string(kMaskChannel), &mask}};
    std::list<ImageF> planes;  // a list: its elements stay where they are
    for (const Channel& channel : gbuffer_channels()) {
        const ImageF& number = gbuffer.number(channel.id);
        if (!number.empty()) channels.push_back({std::string(channel.exr_names[0]), &number});
        add_vectors(gbuffer.vector(channel.id), channel.exr_names, channels, planes);
    }
    add_vectors(positions_m, std::array{"P.X", "P.Y", "P.Z"}, channels, planes);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const SurfaceChannels names(static_cast<int>(i));
        channels.push_back({names.depth, &surfaces[i].depth_m});
        channels.push_back({names.triangle_low, &surfaces[i].triangle_low});
        channels.push_back({names.triangle_high, &surfaces[i].triangle_high});
    }
    write_exr(path, channels, attributes);
}

}  // namespace aoscore
