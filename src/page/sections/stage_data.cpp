#include "page/sections/stage_data.h"

#include "page/document/number_text.h"
#include "page/document/page_template.h"
#include "page/sections/causes.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

using nlohmann::json;

/// An image of the page with its name.
struct NamedImage {
    std::string kind;
    const QuantisedImage& image;
};

std::vector<NamedImage> images_of(const ViewPictures& pictures) {
    std::vector<NamedImage> list = {
        {"truth", pictures.truth}, {"noise", pictures.standard_error}, {"depth", pictures.depth}};
    for (const auto& [id, image] : pictures.occlusion) list.push_back({id, image});
    return list;
}

std::vector<NamedImage> images_of(const CellPictures& pictures) {
    return {{"output", pictures.output}, {"raw", pictures.raw}};
}

std::string name_of(const std::string& owner, const NamedImage& named) {
    return owner + " " + named.kind;
}

json image_data(const QuantisedImage& image, const std::string& block) {
    return {{"data", block},    {"width", image.width}, {"height", image.height},
            {"low", image.low}, {"step", image.step},   {"bytes", image.bytes}};
}

template <class OwnerPictures>
json images_data(const std::string& owner, const OwnerPictures& pictures) {
    json list = json::object();
    for (const NamedImage& named : images_of(pictures)) {
        if (named.image.empty()) continue;
        list[named.kind] = image_data(named.image, name_of(owner, named));
    }
    return list;
}

/// The view's images; its depth may lie among the data of the live methods.
json view_images_data(const ViewRecord& view, const ViewPictures& pictures) {
    json list = images_data(view.key, pictures);
    if (!pictures.depth_block.empty()) {
        list["depth"] = image_data(pictures.depth, pictures.depth_block);
        list["depth"]["exact"] = true;
    }
    return list;
}

json cell_data(const CellRecord& cell, const Pictures& pictures) {
    const auto area = [&](MaskSummary ErrorAnalysis::*mask) {
        return percent_text(cell.analysis ? std::optional((*cell.analysis.*mask).area) : std::nullopt);
    };
    json data = {{"id", cell.id},
                 {"name", fmt::format("{}, {}", shown_name(cell), cell.preset)},
                 {"filter", cell.filter},
                 {"missing", area(&ErrorAnalysis::missing)},
                 {"false", area(&ErrorAnalysis::false_occlusion)},
                 {"images", nullptr}};
    const auto found = pictures.cells.find(cell.id);
    if (found != pictures.cells.end()) data["images"] = images_data(cell.id, found->second);
    return data;
}

json view_data(const ViewRecord& view, const PageSource& source) {
    const ViewPictures& pictures = source.pictures.views.at(view.key);
    const QuantisedImage& error = pictures.standard_error;
    json cells = json::array();
    for (const CellRecord& cell : source.results.cells) {
        if (cell.view_key == view.key) cells.push_back(cell_data(cell, source.pictures));
    }
    return {{"key", view.key},
            {"width", view.width},
            {"height", view.height},
            {"radius", short_text(view.radius_m)},
            {"samples", view.samples},
            {"truthCommand", view.truth_command},
            {"noiseHigh", pictures.has_standard_error ? error.low + error.step * (kErrorLevels - 1) : 0.0},
            {"depthHigh", pictures.depth_high_m},
            {"images", view_images_data(view, pictures)},
            {"cells", std::move(cells)}};
}

template <class PicturesByName>
void append_blocks(std::string& text, const PicturesByName& all) {
    for (const auto& [owner, pictures] : all) {
        for (const NamedImage& named : images_of(pictures)) {
            if (named.image.empty()) continue;
            text += data_block(name_of(owner, named), named.image.data);
        }
    }
}

}  // namespace

std::string stage_data(const PageSource& source) {
    json data = {{"threshold", source.results.mask_threshold},
                 {"command", source.results.command},
                 {"causes", json::array()},
                 {"views", json::array()}};
    for (const CauseText& cause : causes())
        data["causes"].push_back({{"id", cause.id}, {"label", cause.label}});
    for (const ViewRecord& view : source.results.views) data["views"].push_back(view_data(view, source));
    return script_json(data);
}

std::string image_blocks(const PageSource& source) {
    std::string text;
    append_blocks(text, source.pictures.views);
    append_blocks(text, source.pictures.cells);
    return text;
}

}  // namespace aoscore
