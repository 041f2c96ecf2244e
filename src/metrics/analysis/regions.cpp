#include "metrics/analysis/regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace aoscore {
namespace {

/// A region with its sums while it grows.
struct Growing {
    ErrorRegion region;
    int right = 0, bottom = 0;
    double error_sum = 0;
    std::vector<double> occlusion;  ///< by cause

    void add(int x, int y, double error) {
        if (region.area_px == 0) {
            region.left = right = x;
            region.top = bottom = y;
        }
        region.left = std::min(region.left, x);
        right = std::max(right, x);
        region.top = std::min(region.top, y);
        bottom = std::max(bottom, y);
        if (std::abs(error) > std::abs(region.worst_error)) {
            region.worst_error = error;
            region.worst_x = x;
            region.worst_y = y;
        }
        error_sum += error;
        ++region.area_px;
    }

    ErrorRegion finished(const std::vector<PixelFacts::Cause>& causes) {
        region.width = right - region.left + 1;
        region.height = bottom - region.top + 1;
        region.mean_error = error_sum / static_cast<double>(region.area_px);
        const auto most = std::ranges::max_element(occlusion);
        if (most != occlusion.end() && *most > 0)
            region.cause = causes[static_cast<std::size_t>(most - occlusion.begin())].name;
        return region;
    }
};

/// The pieces of one mask, worst first, as many as are listed.
std::vector<ErrorRegion> pieces(Mask mask, const std::string& kind, const MetricInput& input,
                                const std::vector<PixelFacts::Cause>& causes) {
    std::vector<ErrorRegion> found;
    const auto badness = [](const ErrorRegion& r) {
        return std::abs(r.mean_error) * static_cast<double>(r.area_px);
    };
    std::vector<std::pair<int, int>> open;
    const auto take = [&](int x, int y) {
        if (mask.at(x, y) == 0) return;
        mask.at(x, y) = 0;
        open.emplace_back(x, y);
    };
    for (int start_y = 0; start_y < mask.height; ++start_y) {
        for (int start_x = 0; start_x < mask.width; ++start_x) {
            take(start_x, start_y);
            if (open.empty()) continue;
            Growing growing;
            growing.region.kind = kind;
            growing.occlusion.assign(causes.size(), 0);
            while (!open.empty()) {
                const auto [x, y] = open.back();
                open.pop_back();
                const std::size_t i = mask.index(x, y);
                growing.add(x, y, double{input.test.pixels[i]} - double{input.truth.pixels[i]});
                for (std::size_t c = 0; c < causes.size(); ++c)
                    growing.occlusion[c] += double{causes[c].occlusion->pixels[i]};
                for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, mask.height - 1); ++ny) {
                    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, mask.width - 1); ++nx)
                        take(nx, ny);
                }
            }
            found.push_back(growing.finished(causes));
        }
    }
    // Equal ones stay in reading order.
    std::ranges::stable_sort(found, std::ranges::greater(), badness);
    if (found.size() > kListedRegions) found.resize(kListedRegions);
    return found;
}

}  // namespace

std::vector<ErrorRegion> worst_regions(const OcclusionMasks& masks, const MetricInput& input,
                                       const std::vector<PixelFacts::Cause>& causes) {
    std::vector<ErrorRegion> regions = pieces(masks.missing, "missing", input, causes);
    std::ranges::move(pieces(masks.false_occlusion, "false", input, causes), std::back_inserter(regions));
    return regions;
}

}  // namespace aoscore
