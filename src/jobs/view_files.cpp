#include "jobs/view_files.h"

#include "core/signal.h"
#include "image/image_file.h"
#include "image/surface_channels.h"
#include "jobs/image_output.h"
#include "jobs/truth_provenance.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <list>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

constexpr const char *kReportedMs = "aoscore:reported_ms", *kReportedOn = "aoscore:reported_on";

constexpr const char* kSamples = "aoscore:samples";
const std::array<std::string, 3> kColours{"R", "G", "B"};
const std::array<std::string, 3> kHalfDifferences{"half_difference.R", "half_difference.G",
                                                  "half_difference.B"};

/// Pictures in colour as channels of a file.
class ColourChannels {
  public:
    void add(const std::array<std::string, 3>& names, const Image<glm::vec3>& picture) {
        for (int c = 0; c < 3; ++c) {
            ImageF& plane = planes_.emplace_back(picture.width, picture.height);
            for (std::size_t i = 0; i < picture.size(); ++i) plane.pixels[i] = picture.pixels[i][c];
            views_.push_back({names[static_cast<std::size_t>(c)], &plane});
        }
    }
    std::span<const ChannelView> views() const { return views_; }

  private:
    std::list<ImageF> planes_;  // a list: its elements stay where they are
    std::vector<ChannelView> views_;
};

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

void write_irradiance_file(const ViewWork& work, const Irradiance& irradiance) {
    const int width = irradiance.halves[0].width, height = irradiance.halves[0].height;
    Image<glm::vec3> mean(width, height), half_difference(width, height);
    for (std::size_t i = 0; i < mean.size(); ++i) {
        mean.pixels[i] = glm::vec3(irradiance.mean(i));
        half_difference.pixels[i] = (irradiance.halves[0].pixels[i] - irradiance.halves[1].pixels[i]) / 2.0F;
    }
    ColourChannels channels;
    channels.add(kColours, mean);
    channels.add(kHalfDifferences, half_difference);
    write_exr(work.folder / work.irradiance_file(), channels.views(),
              {{"aoscore:view", work.key},
               {"aoscore:environment", work.environment->id()},
               {kSamples, fmt::format("{}", irradiance.samples)}});
}

std::optional<Irradiance> irradiance_of(const ImageFile& file) {
    Irradiance irradiance;
    irradiance.halves.fill(Image<glm::vec3>(file.width, file.height));
    for (int c = 0; c < 3; ++c) {
        const auto name = static_cast<std::size_t>(c);
        const ImageF *mean = file.channel(kColours[name]), *apart = file.channel(kHalfDifferences[name]);
        if (mean == nullptr || apart == nullptr) return std::nullopt;
        for (std::size_t i = 0; i < mean->size(); ++i) {
            irradiance.halves[0].pixels[i][c] = mean->pixels[i] + apart->pixels[i];
            irradiance.halves[1].pixels[i][c] = mean->pixels[i] - apart->pixels[i];
        }
    }
    const auto samples = file.attributes.find(kSamples);
    if (samples == file.attributes.end()) return std::nullopt;
    const std::string& text = samples->second;
    std::from_chars(text.data(), text.data() + text.size(), irradiance.samples);
    return irradiance;
}

void write_lit_file(const ViewWork& work, const CellWork& cell, std::span<const LitPicture> pictures) {
    ColourChannels channels;
    for (const LitPicture& picture : pictures) channels.add(picture.mode.channels(), picture.irradiance);
    write_exr(work.folder / work.lit_file(cell), channels.views(),
              {{"aoscore:cell", cell.id}, {"aoscore:environment", work.environment->id()}});
}

std::optional<ReportedCost> reported_cost(const ImageFile& file) {
    const auto ms = file.attributes.find(kReportedMs), on = file.attributes.find(kReportedOn);
    if (ms == file.attributes.end() || on == file.attributes.end()) return std::nullopt;
    ReportedCost cost{0, on->second};
    std::from_chars(ms->second.data(), ms->second.data() + ms->second.size(), cost.ms);
    return cost;
}

}  // namespace aoscore
