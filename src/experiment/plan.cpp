#include "experiment/plan.h"

#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/strict_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace aoscore {
namespace {

constexpr double kLargestRadius_m = 1e6;
constexpr double kSmallestRadius_m = 1e-9;

std::string source_line(StrictObject source) {
    std::string line = fmt::format("{}, {}, {}", source.text("author"), source.text("title"),
                                   source.integer("year", 1900, 2100));
    if (source.has("place")) line += ", " + source.text("place");
    source.finish();
    return line;
}

// The published figures are shown, not computed with: they may be any numbers, null where nothing was
// printed.
void check_published(StrictObject published, const std::string& where) {
    for (const auto& [key, value] : published.members()) {
        if (!value.is_number() && !value.is_null()) {
            throw file_error("is no number", where + ".published." + key,
                             "a number, or null where none is printed");
        }
    }
}

void check_alternatives(StrictObject alternatives) {
    for (const auto& [key, value] : alternatives.members()) {
        if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_string()) {
            throw file_error("has another form", alternatives.where(key),
                             "[number, \"where it is printed\"]");
        }
    }
}

CellPlan read_row(StrictObject row) {
    CellPlan cell;
    cell.method = row.text("method");
    cell.preset = row.text("preset");
    check_published(row.object("published"), row.where());
    if (row.has("alternatives")) check_alternatives(row.object("alternatives"));
    row.texts_or_empty("notes");
    row.finish();
    return cell;
}

std::pair<int, int> read_size(StrictObject& object) {
    const std::vector<double> size = object.numbers("size", 2);
    for (const double side : size) {
        if (side != std::floor(side) || side < 1 || side > kLargestImageSide_px) {
            throw file_error(fmt::format("holds {}", side), object.where("size"),
                             fmt::format("width and height in pixels, 1 to {}", kLargestImageSide_px));
        }
    }
    return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

bool same_picture(const ViewPlan& a, const ViewPlan& b) {
    return a.scene == b.scene && a.view == b.view && a.width == b.width && a.height == b.height &&
           a.radius_m == b.radius_m;
}

template <class T, class Same>
std::size_t find_or_add(std::vector<T>& items, T item, Same same) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const T& other) { return same(other, item); });
    if (found != items.end()) return static_cast<std::size_t>(found - items.begin());
    items.push_back(std::move(item));
    return items.size() - 1;
}

void add_report(ExperimentPlan& plan, const ReportDefinition& report) {
    TablePlan table;
    table.definition = parse_json_file(report.file);
    StrictObject object(table.definition, report.file.filename().string());
    for (const char* key : {"id", "title", "hardware"}) object.text(key);
    source_line(object.object("source"));
    object.texts_or_empty("notes");

    ViewPlan view;
    view.scene = object.text("scene");
    view.view = object.text("view");
    std::tie(view.width, view.height) = read_size(object);
    view.samples = object.integer("samples", 1, 1 << 20);
    view.max_error = object.number_or("error", 0, 1e-4, 0.5);
    view.radius_m = object.number("radius_m", kSmallestRadius_m, kLargestRadius_m);
    std::vector<StrictObject> rows = object.objects("rows");
    object.finish();

    const int samples = view.samples;
    const double max_error = view.max_error;
    table.view_index = find_or_add(plan.views, std::move(view), same_picture);
    ViewPlan& shared = plan.views[table.view_index];
    shared.samples = std::max(shared.samples, samples);
    // The smaller of the two, where 0 asks for none.
    if (shared.max_error == 0 || (max_error > 0 && max_error < shared.max_error))
        shared.max_error = max_error;
    for (StrictObject& row : rows) {
        table.cell_indices.push_back(find_or_add(shared.cells, read_row(row), std::equal_to<>()));
    }
    plan.tables.push_back(std::move(table));
}

}  // namespace

std::vector<ReportDefinition> list_reports() {
    std::vector<ReportDefinition> reports;
    const std::filesystem::path folder = home_dir() / "reports";
    std::error_code ec;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ec)) {
        if (entry.path().extension() != ".json") continue;
        const nlohmann::json json = parse_json_file(entry.path());
        StrictObject object(json, entry.path().filename().string());
        ReportDefinition report;
        report.id = entry.path().stem().string();
        if (object.text("id") != report.id) {
            throw file_error("is " + object.text("id"), object.where("id"), "the file's stem, " + report.id);
        }
        report.title = object.text("title");
        report.source = source_line(object.object("source"));
        report.file = entry.path();
        reports.push_back(std::move(report));
    }
    std::sort(reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return reports;
}

ExperimentPlan plan_reports(const std::vector<std::string>& report_ids) {
    const std::vector<ReportDefinition> known = list_reports();
    ExperimentPlan plan;
    for (const std::string& id : report_ids) {
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const auto& r) { return r.id == id; });
        if (found == known.end()) {
            std::vector<std::string> ids;
            for (const ReportDefinition& report : known) ids.push_back(report.id);
            throw usage_error("unknown report " + id, "run", fmt::format("{}", fmt::join(ids, ", ")));
        }
        add_report(plan, *found);
    }
    return plan;
}

}  // namespace aoscore
