#include "image/frame_layout.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/text.h"
#include "image/channel_meaning.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace aoscore {
namespace {

bool is_number(const std::string& word) {
    return !word.empty() && std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The last word of a file's stem that is no number: "linearZ" of "Mogwai.GBufferRaster.linearZ.120".
std::string word_of(const std::filesystem::path& path) {
    std::string stem = path.stem().string();
    for (auto dot = stem.rfind('.'); dot != std::string::npos; dot = stem.rfind('.')) {
        if (!is_number(stem.substr(dot + 1))) return stem.substr(dot + 1);
        stem.erase(dot);
    }
    return stem;
}

bool is_plain_component(const std::string& name) {
    static const std::set<std::string, std::less<>> kPlain = {"r", "g", "b", "a", "y"};
    return kPlain.contains(lower_case(name));
}

bool has_name(const FrameLayout& layout, std::string_view wanted, const std::string& name) {
    if (name == wanted) return true;
    return layout.in_any_layer && name.ends_with("." + std::string(wanted));
}

}  // namespace

const std::vector<DepthKindName>& depth_kinds() {
    static const std::vector<DepthKindName> table = {{"view", DepthKind::view},
                                                     {"negative-view", DepthKind::negative_view},
                                                     {"distance", DepthKind::distance},
                                                     {"window", DepthKind::window},
                                                     {"reversed-window", DepthKind::reversed_window}};
    return table;
}

// Blender: source/blender of 3.4 names its passes so, and Cycles writes camera_z_depth(), 1e10 on background.
// Falcor: kGBufferChannels and kGBufferExtraChannels of its GBuffer passes; linearZ is w in clip space.
// three.js: a DepthTexture and MeshNormalMaterial, one file each, as EXRExporter writes a render target.
const std::vector<FrameLayout>& frame_layouts() {
    static const std::vector<FrameLayout> table = {
        {.id = "aoscore",
         .program = "aoscore gbuffer",
         .depth = {"Z"},
         .normal_geometric = {"N.X"},
         .normal_smooth = {"Ns.X"},
         .turned = true,
         .albedo = {"albedo.R"},
         .in_any_layer = false,
         .attribute = "aoscore:near_m"},
        {.id = "blender",
         .program = "Blender's passes Z and Normal (File Output or a multi-layer EXR)",
         .depth = {"Depth.Z", "Depth.V", "Depth.R"},
         .background_from = 1e9,
         .normal_smooth = {"Normal.X", "Normal.R"},
         .world_normals = true,
         .albedo = {"DiffCol.R"}},
        {.id = "falcor",
         .program = "Falcor's GBufferRaster or GBufferRT, outputs captured into one file each",
         .depth = {"linearZ.R"},
         .normal_geometric = {"faceNormalW.R"},
         .normal_smooth = {"guideNormalW.R", "normW.R"},
         .world_normals = true,
         .albedo = {"diffuseOpacity.R"}},
        {.id = "three",
         .program = "three.js: a DepthTexture and MeshNormalMaterial through EXRExporter, one file each",
         .depth = {"depth.R", "depth.Y"},
         .depth_kind = DepthKind::window,
         .normal_smooth = {"normal.R"},
         .packed_normals = true,
         .albedo = {"albedo.R"}},
    };
    return table;
}

std::optional<std::size_t> find_channel(const FrameLayout& layout, const std::vector<std::string_view>& names,
                                        const ImageFile& file) {
    for (const std::string_view wanted : names) {
        for (std::size_t c = 0; c < file.channel_names.size(); ++c) {
            if (has_name(layout, wanted, file.channel_names[c])) return c;
        }
    }
    return std::nullopt;
}

std::optional<std::vector<std::size_t>> three_channels(std::size_t first, const ImageFile& file) {
    const std::string& name = file.channel_names[first];
    const std::string layer = name.substr(0, name.size() - 1);
    const std::string_view components = name.back() == 'R' ? "RGB" : "XYZ";
    std::vector<std::size_t> channels;
    for (const char component : components) {
        const auto index = file.index(layer + component);
        if (!index) return std::nullopt;
        channels.push_back(*index);
    }
    return channels;
}

const FrameLayout& layout_of(const ImageFile& file, const std::string& id, const std::string& where) {
    if (!id.empty()) {
        const FrameLayout& layout = row_of(frame_layouts(), id, "no layout", "--layout");
        if (find_channel(layout, layout.depth, file)) return layout;
        throw file_error(fmt::format("has no depth as the layout {} names it, among {}", id,
                                     fmt::join(file.channel_names, ", ")),
                         where, fmt::format("{}", fmt::join(layout.depth, ", ")));
    }
    std::vector<std::string> known;
    for (const FrameLayout& layout : frame_layouts()) {
        known.push_back(fmt::format("{} ({})", layout.depth.front(), layout.id));
        const bool attributed =
            layout.attribute.empty() || file.attributes.contains(std::string(layout.attribute));
        if (attributed && find_channel(layout, layout.depth, file)) return layout;
    }
    throw file_error(
        fmt::format("has no depth that a layout names, among {}", fmt::join(file.channel_names, ", ")), where,
        fmt::format("one of {}; or --layout", fmt::join(known, ", ")));
}

ImageFile read_frame_files(const std::vector<std::filesystem::path>& files) {
    ImageFile frame;
    for (const std::filesystem::path& path : files) {
        ImageFile file = read_image(path);
        if (frame.channels.empty()) {
            frame.width = file.width;
            frame.height = file.height;
        }
        if (file.width != frame.width || file.height != frame.height) {
            throw Error(ExitCode::sizes_differ,
                        fmt::format("is {}x{}, and the frame's first file {}x{}", file.width, file.height,
                                    frame.width, frame.height),
                        path.string(), "files of one size");
        }
        for (std::size_t c = 0; c < file.channels.size(); ++c) {
            std::string& name = file.channel_names[c];
            if (is_plain_component(name)) name = word_of(path) + "." + name;
            frame.channel_names.push_back(std::move(name));
            frame.channels.push_back(std::move(file.channels[c]));
            frame.covered.push_back(file.covered[c]);
        }
        for (const std::string& doubt : file.doubts) frame.doubts.push_back(path.string() + ": " + doubt);
        frame.attributes.merge(std::move(file.attributes));
    }
    return frame;
}

}  // namespace aoscore
