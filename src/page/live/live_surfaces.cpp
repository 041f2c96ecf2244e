#include "page/live/live_surfaces.h"

#include "core/error.h"
#include "core/threads.h"
#include "image/surface_channels.h"
#include "page/live/live_preview.h"
#include "page/live/surface_packing.h"
#include "page/pictures/stored_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

constexpr const char* kDepthName = "Z";

/// One of the surfaces at each pixel.
struct KeptSurface {
    ImageF depth_m;                 ///< positive
    Image<std::uint32_t> triangle;  ///< the number on which coins depend, later its place among them all
    Mask behind;                    ///< 1 where the face is seen from behind
};

std::uint32_t half_of(float half) {
    return static_cast<std::uint32_t>(std::lround(half)) & 0xffffU;
}

KeptSurface read_surface(const ImageFile& file, const std::filesystem::path& path, int layer) {
    const SurfaceChannels names(layer);
    const ImageF& depth = channel_of(file, path, names.depth);
    const ImageF& low = channel_of(file, path, names.triangle_low);
    const ImageF& high = channel_of(file, path, names.triangle_high);
    KeptSurface surface{depth, Image<std::uint32_t>(depth.width, depth.height),
                        Mask(depth.width, depth.height)};
    for (std::size_t i = 0; i < depth.size(); ++i) {
        surface.depth_m.pixels[i] = std::abs(depth.pixels[i]);
        surface.behind.pixels[i] = depth.pixels[i] < 0 ? 1 : 0;
        surface.triangle.pixels[i] = half_of(low.pixels[i]) | half_of(high.pixels[i]) << 16U;
    }
    return surface;
}

std::vector<KeptSurface> read_surfaces(const ImageFile& file, const std::filesystem::path& path) {
    const auto said = file.attributes.find(SurfaceChannels::kCount);
    if (said == file.attributes.end())
        throw file_error(fmt::format("lacks the attribute {}", SurfaceChannels::kCount), path.string());
    std::vector<KeptSurface> surfaces;
    while (std::to_string(surfaces.size()) != said->second) {
        if (static_cast<int>(surfaces.size()) == SurfaceChannels::kMost)
            throw file_error("is " + said->second, path.string() + ": " + SurfaceChannels::kCount,
                             fmt::format("0 to {}", SurfaceChannels::kMost));
        surfaces.push_back(read_surface(file, path, static_cast<int>(surfaces.size())));
    }
    return surfaces;
}

/// The numbers of all triangles, sorted: neighbours in a mesh are neighbours here, which is short when
/// packed.
std::vector<std::uint32_t> numbers_of(const std::vector<KeptSurface>& surfaces) {
    std::vector<std::uint32_t> numbers;
    for (const KeptSurface& surface : surfaces) {
        std::vector<std::uint32_t> own = surface.triangle.pixels;
        std::ranges::sort(own);
        own.erase(std::unique(own.begin(), own.end()), own.end());
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

void number_triangles(KeptSurface& surface, const std::vector<std::uint32_t>& numbers) {
    for (std::size_t i = 0; i < surface.triangle.size(); ++i) {
        const auto place = std::ranges::lower_bound(numbers, surface.triangle.pixels[i]) - numbers.begin();
        surface.triangle.pixels[i] = 2 * static_cast<std::uint32_t>(place) + surface.behind.pixels[i];
    }
}

struct PackedSurface {
    std::string depths, triangles;
};

PackedSurface pack_surface(const ImageF& depth_m, const Image<std::uint32_t>& triangle) {
    return {pack_depths(depth_m, triangle), pack_triangles(triangle)};
}

double full_share(const std::vector<KeptSurface>& surfaces, double far_m) {
    if (static_cast<int>(surfaces.size()) < SurfaceChannels::kMost) return 0;
    const ImageF& last = surfaces.back().depth_m;
    const auto far = static_cast<float>(far_m);
    const auto full = std::ranges::count_if(last.pixels, [&](float z) { return z < far; });
    return static_cast<double>(full) / static_cast<double>(last.size());
}

}  // namespace

PackedSurfaces pack_surfaces(const ImageFile& gbuffer, const std::filesystem::path& path, double far_m,
                             const std::string& name, const std::string& depth_block, int factor,
                             const std::function<void(std::string, std::string)>& add_block) {
    std::vector<KeptSurface> surfaces = read_surfaces(gbuffer, path);
    const std::vector<std::uint32_t> numbers = numbers_of(surfaces);
    std::vector<PackedSurface> full(surfaces.size()), preview(surfaces.size());
    parallel_for(surfaces.size(), [&](std::size_t i) {
        number_triangles(surfaces[i], numbers);
        full[i] = pack_surface(surfaces[i].depth_m, surfaces[i].triangle);
        preview[i] =
            pack_surface(preview_of(surfaces[i].depth_m, factor), preview_of(surfaces[i].triangle, factor));
    });
    const std::string numbers_block = name + " numbers";
    const bool first_is_depth = !depth_block.empty() && !surfaces.empty() &&
                                surfaces[0].depth_m.pixels == channel_of(gbuffer, path, kDepthName).pixels;
    const json empty = {{"depths", json::array()},
                        {"first_is_depth", first_is_depth},
                        {"triangles", json::array()},
                        {"numbers", numbers_block},
                        {"count", numbers.size()}};
    PackedSurfaces packed{empty, empty, full_share(surfaces, far_m)};
    add_block(numbers_block, pack_integers(numbers, std::max<int>(static_cast<int>(numbers.size()), 1)));
    const auto add = [&](json& index, const char* list, const std::string& block, std::string& text) {
        index[list].push_back(block);
        add_block(block, std::move(text));
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const std::string depths = fmt::format("{} depths {}", name, i);
        const std::string triangles = fmt::format("{} triangles {}", name, i);
        if (i == 0 && first_is_depth) {
            packed.index["depths"].push_back(depth_block);
            packed.preview_index["depths"].push_back(depth_block + " preview");
        } else {
            add(packed.index, "depths", depths, full[i].depths);
            add(packed.preview_index, "depths", depths + " preview", preview[i].depths);
        }
        add(packed.index, "triangles", triangles, full[i].triangles);
        add(packed.preview_index, "triangles", triangles + " preview", preview[i].triangles);
    }
    return packed;
}

}  // namespace aoscore
