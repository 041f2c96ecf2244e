#include "page/tuning_page.h"

#include "core/counted.h"
#include "core/files.h"
#include "core/folders.h"
#include "metrics/evaluate.h"
#include "page/document/html_document.h"
#include "page/document/number_text.h"
#include "page/document/page_parts.h"
#include "page/document/page_template.h"
#include "page/sections/listing.h"
#include "page/tuning_front.h"
#include "results/tuning_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kDecimals = 4;

std::string signed_text(double value) {
    return (value > 0 ? "+" : "") + fixed_text(value, kDecimals);
}

std::string loss_text(double loss) {
    return fixed_text(loss, kDecimals);
}

std::string limit_text(const BudgetRecord& budget) {
    std::vector<std::string> limits;
    if (budget.most_fetches) limits.push_back(short_text(*budget.most_fetches) + " fetches");
    if (budget.most_ms) limits.push_back(short_text(*budget.most_ms) + " ms");
    return limits.empty() ? kNoNumber : fmt::format("{}", fmt::join(limits, ", "));
}

std::string cost_text(const SettingsRecord& settings) {
    std::string text = fixed_text(settings.fetches, 1);
    if (settings.ms) text += " (" + fixed_text(settings.ms, 2) + " ms)";
    return text;
}

/// What counts: the strictest groups that were left out, scenes where there are several.
const HeldOutRecord* strictest(const BudgetRecord& budget) {
    return budget.held_out.empty() ? nullptr : &budget.held_out.back();
}

json row_of(const MethodTuningRecord& method, const BudgetRecord& budget, const HeldOutRecord* held_out) {
    json row = {{"method", method.label},
                {"preset", budget.preset_id},
                {"limit", limit_text(budget)},
                {"published", loss_text(budget.published.loss)},
                {"fitted", loss_text(budget.tuned.loss)},
                {"left_out", kNoNumber},
                {"held_out", kNoNumber},
                {"optimism", kNoNumber},
                {"change", kNoNumber},
                {"verdict", "in sample alone"},
                {"cost", cost_text(budget.published) + " → " + cost_text(budget.tuned)}};
    if (held_out == nullptr) return row;
    row["left_out"] = "a " + held_out->left_out;
    row["held_out"] = loss_text(held_out->loss);
    row["optimism"] = signed_text(held_out->loss - budget.tuned.loss);
    row["change"] =
        fmt::format("{} ({} to {})", signed_text(held_out->less_published),
                    signed_text(held_out->less_published_95[0]), signed_text(held_out->less_published_95[1]));
    row["verdict"] = held_out->verdict;
    return row;
}

json rows_model(const TuningRecord& tuning) {
    json rows = json::array();
    for (const MethodTuningRecord& method : tuning.methods) {
        for (const BudgetRecord& budget : method.budgets) {
            if (budget.held_out.empty()) rows.push_back(row_of(method, budget, nullptr));
            for (const HeldOutRecord& held_out : budget.held_out)
                rows.push_back(row_of(method, budget, &held_out));
        }
    }
    return rows;
}

/// The names of presets with this verdict on what was left out.
std::vector<std::string> with_verdict(const TuningRecord& tuning, const std::string& verdict) {
    std::vector<std::string> names;
    for (const MethodTuningRecord& method : tuning.methods) {
        for (const BudgetRecord& budget : method.budgets) {
            const HeldOutRecord* held_out = strictest(budget);
            if (held_out == nullptr || held_out->verdict != verdict) continue;
            const bool is_plain = method.preset == "default" && method.budgets.size() == 1;
            names.push_back(is_plain ? method.label : method.label + " (" + budget.preset_id + ")");
        }
    }
    return names;
}

std::string verdict_text(const TuningRecord& tuning) {
    const struct {
        const char* verdict;
        const char* words;
    } kinds[] = {{"closer", "are closer to the truth than the published ones"},
                 {"tie", "tie with the published ones"},
                 {"farther", "are farther from the truth than the published ones"}};
    std::vector<std::string> parts;
    for (const auto& [verdict, words] : kinds) {
        std::vector<std::string> names = with_verdict(tuning, verdict);
        if (names.empty()) continue;
        parts.push_back(fmt::format("{} of {} {}", parts.empty() ? "the tuned settings" : "those",
                                    listed(std::move(names)), words));
    }
    if (parts.empty())
        return "Nothing was left out, so it is not known how these settings do on other views.";
    return fmt::format("On what was left out, {}.", fmt::join(parts, "; "));
}

json worth_model(const TuningRecord& tuning) {
    json list = json::array();
    for (const MethodTuningRecord& method : tuning.methods) {
        for (const BudgetRecord& budget : method.budgets) {
            json parameters = json::array();
            for (const WorthRecord& worth : budget.worth) {
                parameters.push_back(
                    {{"parameter", worth.parameter},
                     {"published", short_text(worth.published)},
                     {"tuned", short_text(worth.tuned)},
                     {"alone", loss_text(worth.loss_alone)},
                     {"alone_change", signed_text(worth.loss_alone - budget.published.loss)},
                     {"without", loss_text(worth.loss_without)},
                     {"without_change", signed_text(worth.loss_without - budget.tuned.loss)}});
            }
            list.push_back({{"method", method.label},
                            {"preset", budget.preset_id},
                            {"published", loss_text(budget.published.loss)},
                            {"tuned", loss_text(budget.tuned.loss)},
                            {"parameters", std::move(parameters)}});
        }
    }
    return list;
}

json views_model(const TuningRecord& tuning) {
    json rows = json::array();
    for (std::size_t v = 0; v < tuning.views.size(); ++v) {
        json numbers = json::array();
        for (const MethodTuningRecord& method : tuning.methods) {
            for (const BudgetRecord& budget : method.budgets)
                numbers.push_back({{"published", loss_text(budget.published.loss_by_view[v])},
                                   {"tuned", loss_text(budget.tuned.loss_by_view[v])}});
        }
        rows.push_back({{"view", tuning.views[v].view},
                        {"radius", short_text(tuning.views[v].radius_m)},
                        {"numbers", std::move(numbers)}});
    }
    return rows;
}

json front_model(const std::vector<TunedPoint>& points) {
    json rows = json::array();
    for (const TunedPoint& point : points) {
        if (point.on_front)
            rows.push_back({{"name", point.name},
                            {"fetches", fixed_text(point.fetches, 1)},
                            {"loss", loss_text(point.loss)}});
    }
    return rows;
}

json files_model(const TuningRecord& tuning, const fs::path& folder) {
    json files = json::array();
    for (const MethodTuningRecord& method : tuning.methods) {
        const auto has_it = [&](const json& file) { return file.at("id") == method.method; };
        if (std::ranges::any_of(files, has_it)) continue;  // it holds those tuned from another preset too
        const fs::path name = preset_file_name(method.method);
        files.push_back({{"method", method.label},
                         {"id", method.method},
                         {"name", name.string()},
                         {"text", read_file(folder / name)}});
    }
    return files;
}

json page_model(const TuningRecord& tuning, const fs::path& folder) {
    const Metric& decides = metric(tuning.metric);
    const std::vector<TunedPoint> points = tuned_points(tuning);
    json columns = json::array();
    for (const MethodTuningRecord& method : tuning.methods) {
        for (const BudgetRecord& budget : method.budgets)
            columns.push_back({{"label", method.label + ", " + budget.preset_id}});
    }
    return {{"verdict", verdict_text(tuning)},
            {"rows", rows_model(tuning)},
            {"worth", worth_model(tuning)},
            {"columns", std::move(columns)},
            {"views", views_model(tuning)},
            {"front", front_model(points)},
            {"chart", tuned_points_svg(points, std::string(decides.label))},
            {"files", files_model(tuning, folder)},
            {"metric", std::string(decides.in_text)},
            {"higher", decides.better == Metric::Better::higher},
            {"magnitude", decides.better == Metric::Better::nearer_zero},
            {"size", fmt::format("{}×{}", tuning.size[0], tuning.size[1])},
            {"rays", std::to_string(tuning.rays_a_pixel)},
            {"view_count", counted(tuning.views.size(), "view", "views")},
            {"command", tuning.command},
            {"definition", tuning.definition},
            {"version", tuning.program_version},
            {"created", tuning.created_utc}};
}

}  // namespace

fs::path write_tuning_page(const fs::path& results_folder) {
    const TuningRecord tuning = read_tuning_record(results_folder);
    const fs::path parts = data_dir() / "reports" / "tunings" / "page";
    const fs::path frame = parts / "template.html", path = results_folder / "index.html";
    const std::string style =
        read_file(page_folder() / "style" / "page.css") + read_file(parts / "style.css");
    write_atomically(
        path,
        html_text({"tuning", style, read_file(parts / "script.js"),
                   fill_template(read_file(frame), page_model(tuning, results_folder), frame.string())}));
    return path;
}

}  // namespace aoscore
