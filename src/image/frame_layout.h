#pragma once

#include "image/image_file.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// What the numbers of a frame's depth are.
enum class DepthKind {
    view,             ///< view depth -z, positive
    negative_view,    ///< z of a camera that looks down -z: negative
    distance,         ///< from the camera's centre along the ray
    window,           ///< depth buffer: 0 at the near plane, 1 at the far plane
    reversed_window,  ///< depth buffer: 1 at the near plane, 0 at the far plane
};

/// The table of kinds of depth, by the names that files give them.
struct DepthKindName {
    std::string_view id;
    DepthKind kind;
};
const std::vector<DepthKindName>& depth_kinds();

/// The names that a program gives the pictures of a frame, and what they hold there: a row of the one table.
/// A name stands for its first component; a layer or part before it does not matter where `in_any_layer`.
struct FrameLayout {
    std::string_view id;
    std::string_view program;  ///< which program writes it, and how
    /// Depth by these channels, the first that is there.
    std::vector<std::string_view> depth;
    DepthKind depth_kind = DepthKind::view;
    double background_from = 0;  ///< depths from here on are background; 0: the camera's far plane says
    /// Normals of triangles, and interpolated ones: three neighbouring components from this one on.
    std::vector<std::string_view> normal_geometric = {}, normal_smooth = {};
    bool world_normals = false;   ///< in world space, not the camera's
    bool packed_normals = false;  ///< stored as n/2 + 1/2
    bool turned = false;          ///< normals are already turned to the camera, as this program's own are
    std::vector<std::string_view> albedo;  ///< linear RGB
    bool in_any_layer = true;
    std::string_view attribute =
        {};  ///< it is recognised by this attribute as well; empty: by channels alone
};
const std::vector<FrameLayout>& frame_layouts();

/// The channel by the first of these names that the file has; empty without one.
std::optional<std::size_t> find_channel(const FrameLayout& layout, const std::vector<std::string_view>& names,
                                        const ImageFile& file);

/// The three channels of a picture that begins with this channel: X, Y, Z or R, G, B of one layer. Empty
/// where one of them is missing.
std::optional<std::vector<std::size_t>> three_channels(std::size_t first, const ImageFile& file);

/// The layout of that id, else the first whose depth the file has, and its attribute. Throws usage_error for
/// an unknown id, file_error where none fits; `where` names the file.
const FrameLayout& layout_of(const ImageFile& file, const std::string& id, const std::string& where);

/// Reads the files of one frame as one: channels without a layer, such as R, get the file's word as their
/// layer, "linearZ.R" of "Mogwai.GBufferRaster.linearZ.120.exr". Throws file_error, and sizes_differ.
ImageFile read_frame_files(const std::vector<std::filesystem::path>& files);

}  // namespace aoscore
