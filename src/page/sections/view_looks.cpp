#include "page/sections/view_looks.h"

#include "metrics/evaluate.h"
#include "page/document/number_text.h"
#include "page/document/stage_link.h"
#include "page/sections/causes.h"
#include "page/sections/cost_chart.h"
#include "page/sections/ranking_sentence.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

using nlohmann::json;

const RankingRecord* ranking_of(const Results& results, const std::string& view_key) {
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() == 1 && ranking.view_keys.front() == view_key) return &ranking;
    }
    return nullptr;
}

/// What a picture shows, with the stage's address that shows it large.
json picture_model(const std::string& title, const std::string& text, const std::vector<std::string>& uris,
                   const std::string& link) {
    json images = json::array();
    for (const std::string& uri : uris) images.push_back({{"uri", uri}});
    return {{"title", title}, {"text", text}, {"images", std::move(images)}, {"link", link}};
}

/// Says how far off the worst region is and, where occlusion is missing, what the method did not see.
std::string worst_text(const ErrorRegion& worst) {
    const bool bright = worst.mean_error > 0;
    std::string text = fmt::format("It is too {} by {} over {} pixels", bright ? "bright" : "dark",
                                   fixed_text(std::abs(worst.mean_error), 2), count_text(worst.area_px));
    const auto known = causes();
    const auto cause = std::ranges::find(known, worst.cause, &CauseText::id);
    if (!bright) return text + ": it adds occlusion that the truth lacks.";
    return cause != known.end() ? fmt::format("{}. There {}.", text, cause->meaning) : text + ".";
}

/// The part of the worst region that is cut out, as the stage's address names it.
std::string worst_box(const FirstLook& look) {
    const ErrorRegion& worst = *look.worst;
    const int left = std::max(worst.left, look.cut_left), top = std::max(worst.top, look.cut_top);
    const int right = std::min(worst.left + worst.width, look.cut_left + look.cut_width);
    const int bottom = std::min(worst.top + worst.height, look.cut_top + look.cut_height);
    return fmt::format("{},{},{},{}", left, top, right - left, bottom - top);
}

json pictures_model(const FirstLook& look, const CellRecord* cell, const std::string& metric_id) {
    const std::string& view = look.view_key;
    json pictures = json::array({picture_model("Truth", "Ray-traced visibility: white is open.", {look.truth},
                                               stage_link({{"view", view}, {"mode", "beside"}}))});
    if (cell == nullptr) return pictures;
    const auto link = [&](const char* picture, const std::string& at) {
        std::vector<std::pair<std::string, std::string>> entries = {
            {"view", view}, {"cell", cell->id}, {"picture", picture}, {"mode", "beside"}};
        if (!at.empty()) entries.emplace_back("at", at);
        return stage_link(entries);
    };
    const std::string name = fmt::format("{}, {}", shown_name(*cell), cell->preset);
    pictures.push_back(picture_model(name,
                                     fmt::format("First in the ranking; {} {}.", metric(metric_id).in_text,
                                                 fixed_text(ranked_value(*cell, metric_id), 4)),
                                     {look.output}, link("output", "")));
    pictures.push_back(
        picture_model("Its signed error",
                      fmt::format("Red is too bright, blue too dark, up to {}.", short_text(kFirstLookRange)),
                      {look.error}, link("error", "")));
    if (!look.worst) return pictures;
    pictures.push_back(picture_model("Its worst region, truth beside output", worst_text(*look.worst),
                                     {look.worst_truth, look.worst_output}, link("output", worst_box(look))));
    return pictures;
}

json look_model(const PageSource& source, const FirstLook& look, bool several) {
    const Results& results = source.results;
    const CellRecord* cell = look.cell_id.empty() ? nullptr : find_cell(results, look.cell_id);
    const RankingRecord* ranking = ranking_of(results, look.view_key);
    const CostChart chart = cost_chart(results, find_view(results, look.view_key));
    const std::string sentence = several && ranking != nullptr ? ranking_sentence(*ranking) : "";
    const std::string cost = ranking != nullptr ? cost_sentence(results, *ranking) : "";
    return {{"key", look.view_key},
            {"first", &look == &source.pictures.looks.front()},
            {"icon", look.icon},
            {"winner", cell != nullptr ? shown_name(*cell) : "every method failed"},
            {"has_sentence", !sentence.empty()},
            {"sentence", sentence},
            {"has_cost", !cost.empty()},
            {"cost", cost},
            {"has_chart", !chart.points.empty()},
            {"metric", std::string(metric(chart.metric).in_text)},
            {"data", chart.data},
            {"pictures", pictures_model(look, cell, chart.metric)}};
}

}  // namespace

json view_looks(const PageSource& source) {
    json looks = json::array();
    for (const FirstLook& look : source.pictures.looks)
        looks.push_back(look_model(source, look, source.pictures.looks.size() > 1));
    return looks;
}

}  // namespace aoscore
