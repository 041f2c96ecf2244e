#include "plan/claims/claim.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/image_size.h"
#include "core/known_names.h"
#include "core/signal.h"
#include "core/strict_json.h"
#include "jobs/truth_signals.h"
#include "plan/claims/claim_sources.h"
#include "plan/claims/quantity.h"
#include "plan/resolved_cell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace aoscore {
namespace {

using nlohmann::json;
using Kind = ClaimCheck::Kind;

constexpr double kAny = std::numeric_limits<double>::max();

struct KindRow {
    const char* id;
    Kind kind;
    std::size_t least_cells, most_cells;
    bool has_range;
};
constexpr std::size_t kMany = 1000;
constexpr std::array kKinds{
    KindRow{"order", Kind::order, 2, kMany, false},
    KindRow{"monotone", Kind::monotone, 2, kMany, false},
    KindRow{"ratio", Kind::ratio, 2, 2, true},
    KindRow{"difference", Kind::difference, 2, 2, true},
    KindRow{"ratio_difference", Kind::ratio_difference, 4, 4, true},
    KindRow{"slope", Kind::slope, 3, kMany, true},
    KindRow{"value", Kind::value, 1, kMany, true},
    KindRow{"spread", Kind::spread, 2, kMany, true},
    KindRow{"gain", Kind::gain, 4, 4, true},
    KindRow{"at_equal_cost", Kind::at_equal_cost, 2, kMany, true},
};

const KindRow& kind_named(const std::string& id, const std::string& where) {
    return row_in_file(kKinds, id, where);
}

class Reader {
  public:
    Reader(ClaimList& list, const json& file, const std::string& where)
        : list_(list), top_(StrictObject::of_file(file, where)), sources_(top_) {}

    void read() {
        list_.id = top_.text("id");
        for (auto& [name, value] : top_.object("views").members()) read_view(name, value);
        StrictObject cells = top_.object("cells");
        for (auto& [name, value] : cells.members()) named_[name] = value;
        for (StrictObject& claim : top_.objects("claims")) list_.claims.push_back(read_claim(claim));
        sources_.finish();
        top_.finish();
    }

  private:
    void read_view(const std::string& name, const json& value) {
        StrictObject object(value, top_.where("views") + "." + name);
        ViewPlan view;
        view.scene = object.text("scene");
        view.view = object.text("view");
        const ImageSize size = read_image_size(object);
        view.width = size.width;
        view.height = size.height;
        view.samples = object.integer("samples", 1, 1 << 20);
        view.radius_m = object.number("radius_m", 1e-9, 1e6);
        view.extras = {};
        view.timing_goal = TimingGoal();
        if (object.has("region")) list_.regions[name] = read_region(object);
        object.finish();
        list_.views[name] = view;
    }

    static ClaimRegion read_region(StrictObject& view) {
        const std::vector<double> sides = view.numbers("region", 4);
        const ClaimRegion region{sides[0], sides[1], sides[2], sides[3]};
        const bool lies_inside = 0 <= region.left && region.left < region.right && region.right <= 1 &&
                                 0 <= region.top && region.top < region.bottom && region.bottom <= 1;
        if (!lies_inside)
            throw file_error("is no part of the picture", view.where("region"),
                             "left, top, right, bottom from 0 to 1");
        return region;
    }

    Claim read_claim(StrictObject& object) {
        Claim claim;
        claim.id = object.text("id");
        claim.source = sources_.cited_by(object);
        claim.place = object.text("place");
        claim.text = object.text("claim");
        claim.own = object.text_or("own", "");
        claim.note = object.text_or("note", "");
        claim.cannot = object.text_or("cannot", "");
        if (object.has("checks") == !claim.cannot.empty())
            throw file_error(claim.id + " needs either checks or a reason why it cannot be told",
                             object.where());
        if (object.has("over")) {
            read_settings(object, claim);
        } else if (object.has("checks")) {
            claim.settings.push_back({"", read_checks(object)});
        }
        object.finish();
        return claim;
    }

    std::vector<ClaimCheck> read_checks(StrictObject& claim) {
        std::vector<ClaimCheck> checks;
        for (StrictObject& check : claim.objects("checks")) checks.push_back(read_check(check));
        if (checks.empty()) throw file_error("is empty", claim.where("checks"), "at least one check");
        return checks;
    }

    // Reads the checks once for each setting, whose values the named cells take.
    void read_settings(StrictObject& object, Claim& claim) {
        const std::string name = object.text("over");
        StrictObject range = top_.object("open_constants").object(name);
        claim.open = range.text("why");
        for (StrictObject& setting : range.objects("settings")) {
            const std::string about = setting.text("about");
            set_ = setting.object("cells").members();
            claim.settings.push_back({about, read_checks(object)});
            setting.finish();
        }
        set_.clear();
        range.finish();
    }

    ClaimCheck read_check(StrictObject& object) {
        ClaimCheck check;
        const KindRow& kind = kind_named(object.text("kind"), object.where("kind"));
        check.kind = kind.kind;
        check.quantity = object.text("quantity");
        const Quantity& quantity = find_quantity(check.quantity, object.where("quantity"));
        check.about = object.text_or("about", "");
        if (kind.has_range) {
            if (object.has("low")) check.low = object.number("low", -kAny, kAny);
            if (object.has("high")) check.high = object.number("high", -kAny, kAny);
            if (!check.low && !check.high) throw file_error("has neither low nor high", object.where());
        }
        if (check.kind == Kind::at_equal_cost) {
            check.cost = object.text("cost");
            find_quantity(check.cost, object.where("cost"));
        }
        if (check.kind == Kind::monotone) check.tolerance = object.number_or("tolerance", 0, 0, kAny);
        const json& cells = object.raw("cells");
        if (!cells.is_array()) throw file_error("is no list", object.where("cells"));
        for (const json& cell : cells) add_cells(check.cells, cell, object.where("cells"));
        for (const ClaimCell& cell : check.cells) require_measured(cell, quantity, object.where("cells"));
        if (check.cells.size() < kind.least_cells || check.cells.size() > kind.most_cells) {
            throw file_error(fmt::format("has {} cells", check.cells.size()), object.where("cells"),
                             fmt::format("{} to {}", kind.least_cells, kind.most_cells));
        }
        object.finish();
        return check;
    }

    void require_measured(const ClaimCell& cell, const Quantity& quantity, const std::string& where) const {
        const auto refuse = [&](std::string_view why) {
            throw file_error(fmt::format("holds {}, {}", cell.label, why), where);
        };
        if (quantity.needs.converged && cell.plan.converged.empty())
            refuse("which does not say what is converged");
        if (!quantity.needs.regional && list_.regions.contains(cell.view))
            refuse(fmt::format("of which {} is measured over the whole picture alone", quantity.id));
        const std::string_view signal = quantity.needs.signal;
        const std::vector<std::string>& asked = cell.plan.signals;
        if (!signal.empty() && std::ranges::find(asked, signal) == asked.end())
            refuse(fmt::format("which does not ask for the signal {}", signal));
    }

    // Reads a cell: a name, or an object that takes a named cell by "like" and changes it.
    json merged(const json& cell, const std::string& where) {
        if (cell.is_string() || cell.contains("like")) {
            const json& name = cell.is_string() ? cell : cell.at("like");
            const auto found = name.is_string() ? named_.find(name.get<std::string>()) : named_.end();
            if (found == named_.end())
                throw file_error("names the cell " + name.dump() + ", which is not there", where);
            json base = merged(found->second, where);
            for (const auto& [changed, changes] : set_) {
                if (changed != found->first) continue;
                for (const auto& [id, value] : changes.items()) set_parameter(base, id, value);
            }
            if (cell.is_string()) return base;
            for (const auto& [key, value] : cell.items()) {
                if (key == "like") continue;
                if (value.is_object() && base.contains(key))
                    base[key].update(value);
                else
                    base[key] = value;
            }
            return base;
        }
        return cell;
    }

    void add_cells(std::vector<ClaimCell>& cells, const json& given, const std::string& where) {
        json cell = merged(given, where);
        if (!cell.contains("vary")) {
            cells.push_back(read_cell(cell, where));
            return;
        }
        const json vary = cell.at("vary");
        cell.erase("vary");
        if (!vary.is_object() || vary.size() != 1)
            throw file_error("varies no single thing", where + ".vary");
        const std::string axis = vary.begin().key();
        for (const json& value : vary.front()) {
            json varied = cell;
            if (axis == "view" || axis == "preset" || axis == "filter" || axis == "method")
                varied[axis] = value;
            else if (is_mode(axis))
                varied["modes"][axis] = value;
            else
                set_parameter(varied, axis, value);
            ClaimCell read = read_cell(varied, where);
            read.label =
                axis + " " + (value.is_string() ? value.get<std::string>() : value.dump()) + draws_text(read);
            if (value.is_number()) read.x = value.get<double>();
            cells.push_back(std::move(read));
        }
    }

    // Sets a parameter of the method, or with its prefix one of the filter.
    static void set_parameter(json& cell, const std::string& id, const json& value) {
        if (id.starts_with(kFilterPrefix))
            cell["filter_set"][id.substr(kFilterPrefix.size())] = value;
        else
            cell["set"][id] = value;
    }

    static bool is_mode(const std::string& id) {
        const auto& modes = run_mode_options();
        return std::any_of(modes.begin(), modes.end(), [&](const RunModeOption& m) { return m.id == id; });
    }

    ClaimCell read_cell(const json& value, const std::string& where) {
        StrictObject object(value, where);
        ClaimCell cell;
        cell.view = object.text("view");
        const auto view = list_.views.find(cell.view);
        if (view == list_.views.end()) throw file_error("names no view: " + cell.view, object.where("view"));
        cell.plan.method = object.text("method");
        cell.plan.preset = object.text_or("preset", "default");
        if (object.has("filter")) cell.plan.filter = object.text("filter");
        if (object.has("set")) cell.plan.overrides = parameter_values(object.object("set"));
        if (object.has("filter_set"))
            cell.plan.filter_overrides = parameter_values(object.object("filter_set"));
        cell.plan.own_truth = object.boolean_or("own_truth", false);
        cell.plan.signals = object.texts_or_empty("signals");
        for (const std::string& id : cell.plan.signals) signal(id);
        if (object.has("modes")) read_modes(object.object("modes"), cell.plan.modes);
        if (object.has("converged")) cell.plan.converged = parameter_values(object.object("converged"));
        read_draws(object, cell);
        cell.plan.keep_image = false;
        object.finish();
        cell.x = double{1} * view->second.width * view->second.height;
        cell.label = fmt::format("{}, {}{}", cell.view, cell_name(cell.plan), draws_text(cell));
        return cell;
    }

    static void read_draws(StrictObject& object, ClaimCell& cell) {
        constexpr int kMostDraws = 256;
        if (object.has("draws")) cell.draws = object.integer("draws", 2, kMostDraws);
        const std::string of = object.text_or("of_draws", "mean");
        cell.best_draw = of == "best";
        if ((of != "mean" && !cell.best_draw) || (cell.best_draw && cell.draws == 1))
            throw file_error("is " + of, object.where("of_draws"), "mean, or best of several draws");
    }

    static std::string draws_text(const ClaimCell& cell) {
        if (cell.draws == 1) return "";
        return fmt::format(", {} of {} draws", cell.best_draw ? "best" : "mean", cell.draws);
    }

    static void read_modes(StrictObject object, RunModes& modes) {
        for (const RunModeOption& mode : run_mode_options()) {
            if (!object.has(mode.id)) continue;
            choose_as_file_says(mode, modes, object.text(mode.id), object.where(mode.id));
        }
        object.finish();
    }

    ClaimList& list_;
    StrictObject top_;
    ClaimSources sources_;
    std::map<std::string, json> named_;
    std::vector<std::pair<std::string, json>> set_;  ///< values of constants left open, by cell
};

}  // namespace

std::vector<CellPlan> ClaimCell::drawn() const {
    std::vector<CellPlan> cells(static_cast<std::size_t>(draws), plan);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].draw = static_cast<int>(i);
    return cells;
}

std::vector<ClaimList> load_claims() {
    return load_claims(data_dir() / "reports" / "claims");
}

std::vector<ClaimList> load_claims(const std::filesystem::path& folder) {
    std::vector<ClaimList> lists;
    if (!std::filesystem::is_directory(folder)) return lists;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".json") continue;
        const json file = parse_json_file(entry.path());
        Reader(lists.emplace_back(), file, entry.path().filename().string()).read();
    }
    std::sort(lists.begin(), lists.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    std::set<std::string> ids;
    for (const ClaimList& list : lists) {
        for (const Claim& claim : list.claims) {
            if (!ids.insert(claim.id).second)
                throw file_error("stands twice", list.id + ".json: " + claim.id);
        }
    }
    return lists;
}

std::vector<ClaimList> chosen_claims(std::vector<ClaimList> lists, const std::vector<std::string>& ids) {
    if (ids.empty()) return lists;
    const std::set<std::string> asked(ids.begin(), ids.end());
    std::set<std::string> missing = asked;
    std::vector<std::string> known;
    for (ClaimList& list : lists) {
        known.push_back(list.id);
        missing.erase(list.id);
        std::erase_if(list.claims, [&](const Claim& claim) {
            known.push_back(claim.id);
            missing.erase(claim.id);
            return !asked.contains(claim.id) && !asked.contains(list.id);
        });
    }
    if (!missing.empty()) throw unknown_name("no claim", *missing.begin(), known, "claims");
    return lists;
}

void scale_views(std::vector<ClaimList>& lists, double factor) {
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * factor))); };
    for (ClaimList& list : lists) {
        for (auto& [name, view] : list.views) {
            view.width = scaled(view.width);
            view.height = scaled(view.height);
        }
    }
}

namespace {

void plan_quantity(ExperimentPlan& plan, const ClaimList& list, const ClaimCheck& check,
                   const std::string& quantity) {
    const QuantityNeeds& needs = find_quantity(quantity, "claims").needs;
    for (const ClaimCell& cell : check.cells) {
        ViewPlan view = list.views.at(cell.view);
        view.own_parameters = true;
        view.lit = needs.lit();
        view.extras = extras_for(cell.plan.signals);
        view.extras.causes = needs.causes;
        const std::size_t index = shared_view(plan, std::move(view));
        for (CellPlan& asked : cell.drawn()) {
            asked.timed = needs.timed();
            asked.whole_frames = needs.whole_frames;
            asked.repeats = needs.repeats;
            asked.lit_by_environment = needs.lit_by_environment;
            shared_cell(plan.views[index], std::move(asked));
        }
    }
}

void plan_check(ExperimentPlan& plan, const ClaimList& list, const ClaimCheck& check) {
    plan_quantity(plan, list, check, check.quantity);
    if (!check.cost.empty()) plan_quantity(plan, list, check, check.cost);
}

}  // namespace

void plan_claims(ExperimentPlan& plan, const std::vector<ClaimList>& lists) {
    for (const ClaimList& list : lists) {
        for (const Claim& claim : list.claims) {
            for (const ClaimSetting& setting : claim.settings) {
                for (const ClaimCheck& check : setting.checks) plan_check(plan, list, check);
            }
        }
    }
}

}  // namespace aoscore
