#include "metrics/roles.h"
#include "results/export/csv_line.h"
#include "results/lengths_text.h"
#include "results/ranked_value.h"
#include "results/sweep_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

namespace aoscore {
namespace {

std::string field(const std::string& text) {
    return text;
}

std::string field(std::optional<double> number) {
    return number ? fmt::format("{:.9g}", *number) : "";
}

std::string field(const ParameterValue& value) {
    return value.text();
}

class Line {
  public:
    template <class T>
    Line& add(const T& value) {
        fields_.push_back(field(value));
        return *this;
    }
    std::string text() const { return csv_line(fields_); }

  private:
    std::vector<std::string> fields_;
};

// Adds the fields of a frame in the order of kFrameColumns.
void add_frame(Line& line, const std::optional<FrameRecord>& frame) {
    for (const double FrameRecord::*number :
         {&FrameRecord::lighting_ms, &FrameRecord::geometry_lighting_ms, &FrameRecord::frame_ms,
          &FrameRecord::geometry_lighting_share, &FrameRecord::ao_share, &FrameRecord::filter_share,
          &FrameRecord::per_second, &FrameRecord::per_second_without_ao, &FrameRecord::per_second_unfiltered})
        line.add(frame ? std::optional((*frame).*number) : std::nullopt);
}
constexpr std::array kFrameColumns{"lighting_ms",
                                   "gbuffer_lighting_ms",
                                   "frame_ms",
                                   "gbuffer_lighting_share",
                                   "ao_share",
                                   "filter_share",
                                   "frames_per_second",
                                   "frames_per_second_without_ao",
                                   "frames_per_second_unfiltered"};

// Makes a row's line; over several views, fields that belong to one view are empty.
std::string line_of(const SweepRecord& sweep, const SweepRow& row, const std::string& views,
                    const std::set<std::string>& axes) {
    const CellRecord& cell = *row.cell;
    const ViewRecord* view = row.view;
    const auto of_view = [&](std::optional<double> number) {
        return view != nullptr ? number : std::nullopt;
    };
    Line line;
    line.add(sweep.title).add(views);
    line.add(of_view(view != nullptr ? view->width : 0)).add(of_view(view != nullptr ? view->height : 0));
    line.add(cell.method).add(cell.role).add(cell.preset).add(cell.filter);
    for (const std::string& axis : axes) {
        const auto found = row.point->at.find(axis);
        if (found == row.point->at.end())
            line.add(std::string());
        else
            line.add(found->second);
    }
    line.add(of_view(view != nullptr ? view->gbuffer.median_ms : std::nullopt));
    line.add(of_view(cell.ao.median_ms)).add(of_view(cell.filter_pass.median_ms));
    line.add(row.cost_ms).add(row.cost_low_ms).add(row.cost_high_ms);
    add_frame(line, row.frame);
    line.add(of_view(static_cast<double>(cell.ao.runs_ms.size())));
    line.add(row.relative_cost).add(row.fetches).add(of_view(cell.layer_bytes));
    line.add(of_view(view != nullptr ? std::optional(view->radius_m) : std::nullopt));
    line.add(of_view(view != nullptr ? std::optional(view->radius_px_median) : std::nullopt));
    line.add(view != nullptr ? lengths_text(cell) : std::string());
    line.add(row.error).add(row.noisy_error).add(row.fitted_error).add(row.unfiltered_error).add(row.bias);
    line.add(row.beyond_layer).add(row.found_of_layers).add(row.found_of_truth).add(row.noise);
    for (const char* id : {kStructureMetric, kPerceptualMetric}) line.add(of_view(value_of(cell.ranked, id)));
    line.add(std::string(row.on_front ? "1" : "0")).add(cell.error);
    return line.text();
}

}  // namespace

std::string sweeps_as_csv(const Results& results) {
    std::set<std::string> axes;
    for (const SweepRecord& sweep : results.sweeps) axes.insert(sweep.axes.begin(), sweep.axes.end());
    Line head;
    for (const char* name :
         {"sweep", "view", "width", "height", "method", "role", "preset_run", "filter_run"})
        head.add(std::string(name));
    for (const std::string& axis : axes) head.add("at." + axis);
    for (const char* name : {"gbuffer_ms", "ao_ms", "filter_ms", "cost_ms", "cost_low_ms", "cost_high_ms"})
        head.add(std::string(name));
    for (const char* name : kFrameColumns) head.add(std::string(name));
    for (const char* name : {"runs", "relative_cost", "fetches", "layer_bytes", "radius_m", "radius_px",
                             "lengths", kRankingMetric, kNoisyRankingMetric})
        head.add(std::string(name));
    for (const char* of : {"_fitted", "_unfiltered"}) head.add(std::string(kRankingMetric) + of);
    for (const char* name : {kBiasMetric, "found_beyond_layer", "found_of_layers", "found_of_truth", "noise",
                             kStructureMetric, kPerceptualMetric, "pareto", "failed"})
        head.add(std::string(name));
    std::string csv = head.text();
    for (const SweepRecord& sweep : results.sweeps) {
        const std::vector<SweepRow> rows = sweep_rows(results, sweep);
        for (const SweepRow& row : rows) csv += line_of(sweep, row, row.view->key, axes);
        for (const SweepRowsOverViews& all : rows_over_views(rows)) {
            std::vector<std::string> keys;
            for (const ViewRecord* view : all.views) keys.push_back(view->key);
            const std::string views = fmt::format("{}", fmt::join(keys, " "));
            for (const SweepRow& row : all.rows) csv += line_of(sweep, row, views, axes);
        }
    }
    return csv;
}

}  // namespace aoscore
