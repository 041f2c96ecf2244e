#include "jobs/view_files.h"

#include "core/signal.h"
#include "image/image_file.h"
#include "image/surface_channels.h"
#include "jobs/image_output.h"
#include "jobs/truth_provenance.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr const char *kReportedMs = "aoscore:reported_ms", *kReportedOn = "aoscore:reported_on";

}  // namespace

void write_truth_file(const ViewWork& work, const CachedTruth& traced, const Ground& ground) {
    std::map<std::string, std::string> header = truth_provenance(work.scene, traced, work.command);
    header["aoscore:view"] = work.key;
    write_truth(work.folder / work.truth_file(), traced.truth, ground.contract.valid, std::move(header));
}

void write_gbuffer_file(const ViewWork& work, const GBufferImages& gbuffer,
                        std::span<const SurfaceLayer> surfaces) {
    std::map<std::string, std::string> header{{"aoscore:view", work.key}};
    if (work.keeps_surfaces()) header[SurfaceChannels::kCount] = std::to_string(surfaces.size());
    write_gbuffer(work.folder / work.gbuffer_file(), gbuffer, {}, header, surfaces);
}

void write_image_file(const ViewWork& work, const CellWork& cell, const ContestantImage& image) {
    std::vector<ChannelView> channels{{"Y", &image.visibility}};
    if (cell.contestant->is_filtered()) channels.push_back({"raw.Y", &image.raw});
    for (const auto& [id, planes] : image.signals) {
        const std::span<const std::string_view> names = signal(id).channels;
        for (std::size_t i = 0; i < planes.size(); ++i)
            channels.push_back({std::string(names[i]), &planes[i]});
    }
    std::map<std::string, std::string> attributes{{"aoscore:cell", cell.id}};
    if (image.cost) {
        attributes[kReportedMs] = fmt::format("{}", image.cost->ms);
        attributes[kReportedOn] = image.cost->on;
    }
    write_exr(work.folder / work.image_file(cell), channels, attributes);
}

std::optional<ReportedCost> reported_cost(const ImageFile& file) {
    const auto ms = file.attributes.find(kReportedMs), on = file.attributes.find(kReportedOn);
    if (ms == file.attributes.end() || on == file.attributes.end()) return std::nullopt;
    ReportedCost cost{0, on->second};
    std::from_chars(ms->second.data(), ms->second.data() + ms->second.size(), cost.ms);
    return cost;
}

}  // namespace aoscore
