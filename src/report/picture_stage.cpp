#include "report/closeness.h"
#include "report/colour_map.h"
#include "report/number_text.h"
#include "report/section.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

/// What a picture shows: a chooser's entry, and its sentence below every figure of the kind.
struct Kind {
    const char* id;
    const char* label;
};
constexpr Kind kOutput{"output", "Output"}, kRaw{"raw", "Raw"}, kError{"error", "Signed error"},
    kMasks{"masks", "Masks"};
constexpr Kind kTruth{"truth", "Truth"}, kStandardError{"noise", "Truth's noise"}, kDepth{"depth", "Depth"};

json bar_model(ColourMap map, const std::string& low, const std::string& middle, const std::string& high,
               const std::string& unit) {
    return {
        {"gradient", css_gradient(map)}, {"low", low}, {"middle", middle}, {"high", high}, {"unit", unit}};
}

json figure_model(const Picture& picture, const Kind& kind, const std::string& cell, const std::string& title,
                  const std::string& text) {
    return {{"kind", kind.id},
            {"cell", cell},
            {"title", title},
            {"text", text},
            {"uri", picture.uri},
            {"width", std::to_string(picture.width)},
            {"height", std::to_string(picture.height)},
            {"bars", json::array()},
            {"keys", json::array()}};
}

void add_view_figures(json& figures, const ViewRecord& view, const ViewPictures& pictures) {
    json truth = figure_model(pictures.truth, kTruth, "", "Truth",
                              fmt::format("Ray-traced visibility, {} samples a pixel, R {} m: white is open.",
                                          view.samples, short_text(view.radius_m)));
    truth["bars"].push_back(bar_model(gray(), "0 occluded", "0.5", "1 open", "visibility"));
    figures.push_back(std::move(truth));
    if (pictures.standard_error) {
        json noise =
            figure_model(pictures.standard_error, kStandardError, "", "Truth's noise",
                         "Standard error of each pixel's truth: no method can be judged finer than this.");
        noise["bars"].push_back(bar_model(magma(), "0", fixed_text(pictures.standard_error_high / 2, 3),
                                          fixed_text(pictures.standard_error_high, 3),
                                          "standard error of visibility"));
        figures.push_back(std::move(noise));
    }
    if (pictures.depth) {
        json depth = figure_model(
            pictures.depth, kDepth, "", "Depth",
            "Linear depth of the G-buffer that all methods read; the farthest 1 % share one colour.");
        depth["bars"].push_back(bar_model(viridis(), fixed_text(pictures.depth_low_m, 1),
                                          fixed_text((pictures.depth_low_m + pictures.depth_high_m) / 2, 1),
                                          fixed_text(pictures.depth_high_m, 1), "m"));
        figures.push_back(std::move(depth));
    }
}

json key_model(Rgb colour, const std::string& text) {
    return {{"colour", css_colour(colour)}, {"text", text}};
}

void add_cell_figures(json& figures, const CellRecord& cell, const std::string& name,
                      const CellPictures& pictures, double threshold) {
    const json visibility_bar = bar_model(gray(), "0 occluded", "0.5", "1 open", "visibility");
    json output =
        figure_model(pictures.output, kOutput, cell.id, name + ": output",
                     cell.filter == "none" ? "The method's visibility; no filter is applied."
                                           : "The method's visibility after the filter " + cell.filter + ".");
    output["bars"].push_back(visibility_bar);
    figures.push_back(std::move(output));
    if (pictures.raw) {
        json raw = figure_model(pictures.raw, kRaw, cell.id, name + ": raw", "The same before the filter.");
        raw["bars"].push_back(visibility_bar);
        figures.push_back(std::move(raw));
    }
    json error =
        figure_model(pictures.error, kError, cell.id, name + ": signed error",
                     "Output minus truth. Red is too bright: occlusion is missing. Blue is too dark.");
    error["bars"].push_back(bar_model(blue_red(), fixed_text(-kErrorRange, 1) + " too dark", "0",
                                      "+" + fixed_text(kErrorRange, 1) + " too bright", "output − truth"));
    error["keys"].push_back(key_model(kInvalidColour, "not compared"));
    figures.push_back(std::move(error));
    json masks = figure_model(pictures.masks, kMasks, cell.id, name + ": masks",
                              fmt::format("Where visibility is off by more than {}, over the truth in gray.",
                                          short_text(threshold)));
    masks["keys"].push_back(key_model(
        kMissingOcclusionColour,
        fmt::format("missing occlusion, {} % of the valid pixels", percent_text(cell.missing_area))));
    masks["keys"].push_back(key_model(kFalseOcclusionColour,
                                      fmt::format("false occlusion, {} %", percent_text(cell.false_area))));
    figures.push_back(std::move(masks));
}

/// The cell that a view opens on: the closest to the truth; empty without any.
std::string first_shown(const Results& results, const std::string& view_key) {
    std::vector<const CellRecord*> cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view_key) cells.push_back(&cell);
    }
    const std::string metric = ranking_metric(cells);
    const CellRecord* closest = nullptr;
    for (const CellRecord* cell : cells) {
        const auto value = ranked_value(*cell, metric);
        if (value && (closest == nullptr || *value < *ranked_value(*closest, metric))) closest = cell;
    }
    return closest != nullptr ? closest->id : "";
}

}  // namespace

nlohmann::json section::pictures(const PageSource& source) {
    json model = {{"views", json::array()}, {"kinds", json::array()}};
    for (const Kind& kind : {kOutput, kError, kMasks, kRaw, kTruth, kStandardError, kDepth}) {
        model["kinds"].push_back({{"id", kind.id}, {"label", kind.label}, {"checked", kind.id == kError.id}});
    }
    for (const ViewRecord& view : source.results.views) {
        json figures = json::array(), cells = json::array();
        const std::string opened = first_shown(source.results, view.key);
        const auto of_view = source.pictures.views.find(view.key);
        if (of_view != source.pictures.views.end()) add_view_figures(figures, view, of_view->second);
        for (const CellRecord& cell : source.results.cells) {
            if (cell.view_key != view.key) continue;
            const std::string name = fmt::format("{}, {}", cell.method_label, cell.preset);
            const auto of_cell = source.pictures.cells.find(cell.id);
            const bool failed = of_cell == source.pictures.cells.end();
            const std::size_t number = cells.size() + 1;
            cells.push_back({{"id", cell.id},
                             {"method", cell.method_label},
                             {"preset", cell.preset},
                             {"number", std::to_string(number)},
                             {"has_key", number <= 9},
                             {"checked", cell.id == opened},
                             {"failed", failed},
                             {"error", cell.error}});
            if (!failed)
                add_cell_figures(figures, cell, name, of_cell->second, source.results.mask_threshold);
        }
        model["views"].push_back({{"key", view.key},
                                  {"checked", model["views"].empty()},
                                  {"width", std::to_string(view.width)},
                                  {"height", std::to_string(view.height)},
                                  {"figures", std::move(figures)},
                                  {"cells", std::move(cells)}});
    }
    return model;
}

}  // namespace aoscore
