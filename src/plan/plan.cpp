#include "plan/plan.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/image_size.h"
#include "core/known_names.h"
#include "core/signal.h"
#include "core/source_reference.h"
#include "core/strict_json.h"
#include "jobs/truth_signals.h"
#include "plan/claims/claim.h"
#include "plan/lit_cells.h"
#include "plan/resolved_cell.h"
#include "plan/run_modes.h"
#include "plan/sweep.h"
#include "plan/tuned_rows.h"
#include "reference/sampling/sample_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace aoscore {
namespace {

constexpr double kLargestRadius_m = 1e6;
constexpr double kSmallestRadius_m = 1e-9;

// Published figures are only shown: they may be any numbers, or null where nothing was printed.
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
    cell.own_truth = true;
    check_published(row.object("published"), row.where());
    if (row.has("alternatives")) check_alternatives(row.object("alternatives"));
    row.texts_or_empty("notes");
    row.finish();
    return cell;
}

bool same_picture(const ViewPlan& a, const ViewPlan& b) {
    return a.scene == b.scene && a.load == b.load && a.view == b.view && a.width == b.width &&
           a.height == b.height && a.radius_m == b.radius_m && a.own_parameters == b.own_parameters &&
           a.environment == b.environment;
}

void set_size(ViewPlan& view, ImageSize size, double scale) {
    view.width = std::max(1, static_cast<int>(std::lround(size.width * scale)));
    view.height = std::max(1, static_cast<int>(std::lround(size.height * scale)));
}

// Checks the results that a source states; they are null where it shows a bar and prints no number.
void check_stated(StrictObject stated) {
    stated.text("what");
    stated.text("where");
    const nlohmann::json& value = stated.raw("value");
    if (!value.is_number() && !value.is_string() && !value.is_null())
        throw file_error("is " + value.dump(), stated.where("value"),
                         "a number, a text, or null where none is printed");
    stated.text_or("unit", "");
    stated.finish();
}

SweepRequest read_sweep(StrictObject object) {
    SweepRequest request;
    request.methods = object.texts_or_empty("methods");
    if (request.methods.empty())
        throw file_error("names no method", object.where("methods"), "ids of methods");
    request.base.preset = object.text_or("preset", "default");
    if (object.has("filter")) request.base.filter = object.text("filter");
    if (object.has("set")) {
        for (const auto& [id, value] : parameter_values(object.object("set")))
            request.set.push_back({id, value});
    }
    request.base.own_truth = false;
    request.base.keep_image = object.boolean_or("images", false);
    request.base.repeats = object.boolean_or("repeats", false);
    request.base.signals = object.texts_or_empty("signals");
    for (const std::string& id : request.base.signals) signal(id);
    for (const auto& [id, values] : object.object("vary").members()) {
        const std::string where = object.where("vary") + "." + id;
        if (!values.is_array() || values.empty()) throw file_error("is no list of values", where);
        SweepAxis& axis = request.axes.emplace_back(id);
        for (const nlohmann::json& value : values) axis.values.push_back(parameter_value(value, where));
    }
    object.finish();
    return request;
}

// Checks the numbers that a source prints of settings of one view: each is of one setting that is measured.
void check_printed(std::vector<StrictObject> printed, std::span<const SweepPoint> points) {
    for (StrictObject& row : printed) {
        const ParameterValues at = parameter_values(row.object("at"));
        const auto matches = [&](const SweepPoint& point) {
            return std::ranges::all_of(at, [&](const auto& value) {
                const auto found = point.at.find(value.first);
                return found != point.at.end() && found->second == value.second;
            });
        };
        if (std::ranges::count_if(points, matches) != 1)
            throw file_error("does not tell one setting of the sweep from the others", row.where("at"));
        for (const char* time : {"ao_ms", "layers_ms"}) {
            if (row.has(time)) row.number(time, 0, 1e6);
        }
        row.finish();
    }
}

void add_sweep(ExperimentPlan& plan, const ExperimentDefinition& experiment, double scale) {
    SweepPlan sweep;
    sweep.definition = parse_json_file(experiment.file);
    StrictObject object = StrictObject::of_file(sweep.definition, experiment.file.filename().string());
    for (const char* key : {"id", "kind", "hardware"}) object.text(key);
    sweep.title = object.text("title");
    source_reference(object.object("source"));
    object.texts_or_empty("notes");
    for (StrictObject& stated : object.objects_or_empty("stated")) check_stated(std::move(stated));
    ViewPlan view;
    view.samples = object.integer("samples", 1, 1 << 20);
    view.radius_m = object.number("radius_m", kSmallestRadius_m, kLargestRadius_m);
    view.extras = {};
    view.own_parameters = true;
    view.timing_goal = TimingGoal();
    view.lit = object.boolean_or("lit", true);
    const std::string environment = object.text_or("environment", "");
    if (!environment.empty()) view.environment = named_environment(environment, 0);
    const Registry registry = load_registry();
    std::vector<SweepRequest> requests;
    for (StrictObject& one : object.objects("sweeps")) {
        SweepRequest& request = requests.emplace_back(read_sweep(std::move(one)));
        request.base.lit_by_environment = !environment.empty();
        view.extras |= extras_for(request.base.signals);
        view.extras.causes |= request.base.repeats;
    }
    for (StrictObject& one : object.objects("views")) {
        view.scene = one.text("scene");
        view.view = one.text("view");
        set_size(view, read_image_size(one), scale);
        const std::size_t first = sweep.points.size();
        for (const SweepRequest& request : requests) add_sweep(plan, view, request, sweep, registry);
        check_printed(one.objects_or_empty("printed"), std::span(sweep.points).subspan(first));
        one.finish();
    }
    const std::vector<std::string> claims = object.texts_or_empty("claims");
    object.finish();  // the definition moves into the plan with the sweep
    plan.sweeps.push_back(std::move(sweep));
    if (claims.empty()) return;
    std::vector<ClaimList> lists = chosen_claims(load_claims(), claims);
    scale_views(lists, scale);
    plan_claims(plan, lists);
    plan.claim_ids.insert(plan.claim_ids.end(), claims.begin(), claims.end());
}

void add_table(ExperimentPlan& plan, const ExperimentDefinition& experiment, double scale) {
    TablePlan table;
    table.definition = parse_json_file(experiment.file);
    StrictObject object = StrictObject::of_file(table.definition, experiment.file.filename().string());
    for (const char* key : {"id", "title", "hardware"}) object.text(key);
    object.text_or("kind", "");
    source_reference(object.object("source"));
    object.texts_or_empty("notes");

    ViewPlan view;
    view.scene = object.text("scene");
    view.view = object.text("view");
    set_size(view, read_image_size(object), scale);
    const std::vector<std::string> claims = object.texts_or_empty("claims");
    plan.claim_ids.insert(plan.claim_ids.end(), claims.begin(), claims.end());
    view.samples = object.integer("samples", 1, 1 << 20);
    view.max_error = object.number_or("error", 0, kLeastError, 0.5);
    view.radius_m = object.number("radius_m", kSmallestRadius_m, kLargestRadius_m);
    std::vector<StrictObject> rows = object.objects("rows");
    object.finish();

    table.view_index = shared_view(plan, std::move(view));
    for (StrictObject& row : rows) {
        table.cell_indices.push_back(shared_cell(plan.views[table.view_index], read_row(row)));
    }
    plan.tables.push_back(std::move(table));
}

void add_ranking(ExperimentPlan& plan, const ExperimentDefinition& experiment, double scale) {
    const nlohmann::json definition = parse_json_file(experiment.file);
    StrictObject object = StrictObject::of_file(definition, experiment.file.filename().string());
    for (const char* key : {"id", "kind", "title"}) object.text(key);
    ViewPlan view;
    view.scene = object.text("scene");
    set_size(view, read_image_size(object), scale);
    view.radius_m = object.number("radius_m", kSmallestRadius_m, kLargestRadius_m);
    const std::vector<MethodDescriptor> methods = load_methods();
    const std::string preset = object.text_or("preset", "default");
    std::vector<CellPlan> cells;
    for (const std::string& id : object.texts_or_empty("methods")) {
        cells.push_back(scored_cells(find_method(methods, id)).front());
        cells.back().preset = preset;
    }
    const std::vector<std::string> views = object.texts_or_empty("views");
    object.finish();
    for (const std::string& id : views) {
        view.view = id;
        const std::size_t index = shared_view(plan, view);
        for (const CellPlan& cell : cells) shared_cell(plan.views[index], cell);
    }
}

}  // namespace

namespace {

// Ids in the order of ExperimentDefinition::Kind.
constexpr std::array<std::string_view, 3> kKindIds{"table", "ranking", "sweep"};
constexpr std::array kAdders{add_table, add_ranking, add_sweep};

}  // namespace

std::vector<CellPlan> scored_cells(const MethodDescriptor& method) {
    CellPlan cell;
    cell.method = method.id;
    for (const auto& [id, choice] : method.scored.modes) {
        const RunModeOption* mode = find_row(run_mode_options(), id);
        const std::string where = (method.folder / "method.json").string() + ": scored.modes";
        if (mode == nullptr) throw file_error(fmt::format("{} {} is no mode of running", id, choice), where);
        choose_as_file_says(*mode, cell.modes, choice, where);
    }
    std::vector<CellPlan> cells;
    for (const std::string& preset : method.scored.presets) {
        cell.preset = preset;
        cells.push_back(cell);
    }
    return cells;
}

bool CellPlan::same_as(const CellPlan& other) const {
    return method == other.method && preset == other.preset && overrides == other.overrides &&
           filter == other.filter && filter_overrides == other.filter_overrides && modes == other.modes &&
           radius_factor == other.radius_factor && signals == other.signals && converged == other.converged &&
           draw == other.draw;
}

bool has_score_goal(const ExperimentPlan& plan) {
    return std::ranges::any_of(plan.views, [](const ViewPlan& view) { return view.score_goal.has_value(); });
}

ExperimentPlan first_answer_of(ExperimentPlan plan) {
    plan.first_answer = true;
    plan.advice.clear();
    for (TablePlan& table : plan.tables) table.tuned.clear();
    for (ViewPlan& view : plan.views) {
        std::erase_if(view.cells, [](const CellPlan& cell) { return cell.step; });
        if (view.score_goal) view.score_goal->every_metric = false;
    }
    return plan;
}

std::size_t shared_view(ExperimentPlan& plan, ViewPlan view) {
    const auto found = std::find_if(plan.views.begin(), plan.views.end(),
                                    [&](const ViewPlan& other) { return same_picture(other, view); });
    if (found == plan.views.end()) {
        plan.views.push_back(std::move(view));
        return plan.views.size() - 1;
    }
    found->samples = std::max(found->samples, view.samples);
    if (!view.score_goal) found->score_goal.reset();
    if (view.max_error > 0)
        found->max_error = found->max_error > 0 ? std::min(found->max_error, view.max_error) : view.max_error;
    found->extras |= view.extras;
    if (view.timing_goal) found->timing_goal = view.timing_goal;
    found->lit |= view.lit;
    return static_cast<std::size_t>(found - plan.views.begin());
}

std::size_t shared_cell(ViewPlan& view, CellPlan cell) {
    const auto found = std::find_if(view.cells.begin(), view.cells.end(),
                                    [&](const CellPlan& other) { return other.same_as(cell); });
    if (found == view.cells.end()) {
        view.cells.push_back(std::move(cell));
        return view.cells.size() - 1;
    }
    found->own_truth |= cell.own_truth;
    found->keep_image |= cell.keep_image;
    found->timed |= cell.timed;
    found->whole_frames |= cell.whole_frames;
    found->repeats |= cell.repeats;
    found->step &= cell.step;
    found->lit_by_environment |= cell.lit_by_environment;
    return static_cast<std::size_t>(found - view.cells.begin());
}

std::vector<ExperimentDefinition> list_experiments() {
    std::vector<ExperimentDefinition> experiments;
    const std::filesystem::path folder = data_dir() / "reports";
    std::error_code ec;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ec)) {
        if (entry.path().extension() != ".json") continue;
        const nlohmann::json definition = parse_json_file(entry.path());
        StrictObject object = StrictObject::of_file(definition, entry.path().filename().string());
        ExperimentDefinition experiment;
        experiment.id = entry.path().stem().string();
        if (object.text("id") != experiment.id) {
            throw file_error("is " + object.text("id"), object.where("id"),
                             "the file's stem, " + experiment.id);
        }
        experiment.title = object.text("title");
        const std::string kind = object.text_or("kind", "table");
        const auto known = std::ranges::find(kKindIds, kind);
        if (known == kKindIds.end())
            throw file_error("is " + kind, object.where("kind"),
                             fmt::format("{}", fmt::join(kKindIds, ", ")));
        experiment.kind = static_cast<ExperimentDefinition::Kind>(known - kKindIds.begin());
        if (experiment.kind != ExperimentDefinition::Kind::ranking)
            experiment.source = source_reference(object.object("source"));
        experiment.file = entry.path();
        experiments.push_back(std::move(experiment));
    }
    std::sort(experiments.begin(), experiments.end(),
              [](const auto& a, const auto& b) { return a.id < b.id; });
    return experiments;
}

ExperimentPlan plan_experiments(const std::vector<std::string>& ids, double scale) {
    const std::vector<ExperimentDefinition> known = list_experiments();
    ExperimentPlan plan;
    plan.claim_scale = scale;
    for (const std::string& id : ids) {
        const ExperimentDefinition& experiment = row_of(known, id, "no experiment", "run");
        kAdders[static_cast<std::size_t>(experiment.kind)](plan, experiment, scale);
    }
    add_tuned_rows(plan);
    return plan;
}

}  // namespace aoscore
