#include "verdict/claim_verdicts.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/node_kind.h"
#include "core/printable.h"
#include "plan/claims/quantity.h"
#include "plan/resolved_cell.h"
#include "verdict/equal_cost.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using Kind = ClaimCheck::Kind;
using Range = Measured::Range;

/// A cell of a check, as found in the results.
struct Found {
    const ClaimCell* asked;
    const CellRecord* cell;
    const ViewRecord* view;
    Measured measured;
    Measured cost;  ///< of a check at equal cost
};

/// One expression of a check with its claimed range.
struct Part {
    std::string what;
    Measured measured;
    std::optional<double> low, high;
    std::string unit;
    int decimals;
};

constexpr const char* kNotMeasured = "this run did not measure";

const ViewRecord* find_view(const Results& results, const ViewPlan& plan) {
    // Takes the view of the same size if there is one, else of any size.
    const ViewRecord* other_size = nullptr;
    for (const ViewRecord& view : results.views) {
        if (view.scene != plan.scene || view.view != plan.view || view.radius_m != plan.radius_m) continue;
        if (view.width == plan.width && view.height == plan.height) return &view;
        if (other_size == nullptr) other_size = &view;
    }
    return other_size;
}

/// The cell with those blocks of its errors alone whose middle lies in a part of the picture.
CellRecord within(const ClaimRegion& region, const CellRecord& cell, const ViewRecord& view) {
    CellRecord part;
    part.id = cell.id;
    if (!cell.analysis) return part;
    part.analysis.emplace();
    const BlockErrors& all = cell.analysis->blocks;
    BlockErrors& some = part.analysis->blocks;
    some.side_px = all.side_px;
    for (std::size_t i = 0; i < all.counts.size(); ++i) {
        const auto across = static_cast<std::size_t>(all.across);
        const double x = (static_cast<double>(i % across) + 0.5) * all.side_px / view.width;
        const double y = (static_cast<double>(i / across) + 0.5) * all.side_px / view.height;
        if (x < region.left || x > region.right || y < region.top || y > region.bottom) continue;
        for (const auto sums : {&BlockErrors::counts, &BlockErrors::squared_sums, &BlockErrors::absolute_sums,
                                &BlockErrors::signed_sums, &BlockErrors::variance_sums,
                                &BlockErrors::missing_counts, &BlockErrors::false_counts}) {
            if (i < (all.*sums).size()) (some.*sums).push_back((all.*sums)[i]);
        }
    }
    some.across = static_cast<int>(some.counts.size());
    some.down = 1;
    return part;
}

/// The quantity over a cell's draws: the mean, whose uncertainty is also that of the draws, which are
/// resampled; or that of the draw with the least.
Measured over_draws(const std::vector<Measured>& of, const ClaimCell& cell, std::uint64_t seed) {
    if (of.size() == 1) return of.front();
    if (cell.best_draw) return *std::ranges::min_element(of, {}, [](const Measured& m) { return *m.value; });
    const double count = static_cast<double>(of.size());
    Measured mean = combined(of, [count](const std::vector<double>& values) {
        return std::accumulate(values.begin(), values.end(), 0.0) / count;
    });
    constexpr std::size_t kResamples = 2000;
    mean.draws.resize(kResamples);
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < mean.draws.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < of.size(); ++k) {
            const Measured& drawn = of[random() % of.size()];
            sum += i < drawn.draws.size() ? drawn.draws[i] : *drawn.value;
        }
        mean.draws[i] = sum / count;
    }
    return mean;
}

class Judge {
  public:
    Judge(const ClaimList& list, const Results& results) : list_(list), results_(results) {}

    ClaimRecord judge(const Claim& claim) {
        ClaimRecord record{claim.id,     claim.source, claim.place, claim.text, ClaimRecord::kCannotTell,
                           claim.cannot, claim.own,    claim.note,  {},         {}};
        if (claim.settings.empty()) return record;
        std::map<std::string, std::vector<std::string>> settings;  // settings by verdict
        for (const ClaimSetting& setting : claim.settings) {
            const std::string verdict = verdict_at(setting, record);
            if (!record.reason.empty()) {
                if (claim.settings.size() > 1 && record.reason.starts_with(kNotMeasured))
                    record.reason = fmt::format("{}: aoscore claims {} judges it at {} settings of them",
                                                claim.open, claim.id, claim.settings.size());
                return record;
            }
            settings[verdict].push_back(setting.about);
        }
        if (settings.size() == 1) {
            record.verdict = settings.begin()->first;
            if (record.verdict == ClaimRecord::kCannotTell)
                record.reason = "what was measured lies too near to the limit for its uncertainty";
        } else {
            record.reason = claim.open;
            for (const auto& [verdict, where] : settings)
                record.reason += "; it " + verdict + " at " + settings_text(where, claim.settings.size());
        }
        if (claim.settings.size() > 1 && settings.size() == 1)
            record.note += fmt::format("{}{}: it is the same at all {} settings that were tried.",
                                       record.note.empty() ? "" : " ", claim.open, claim.settings.size());
        return record;
    }

  private:
    static std::string settings_text(const std::vector<std::string>& where, std::size_t all) {
        constexpr std::size_t kMostNamed = 3;
        const std::string count = fmt::format("{} of {} settings", where.size(), all);
        return where.size() > kMostNamed ? count : fmt::format("{} ({})", count, fmt::join(where, "; "));
    }

    /// The verdict at one setting: it fails when one part does, and holds when all do.
    std::string verdict_at(const ClaimSetting& setting, ClaimRecord& record) {
        std::set<std::string> outcomes;
        for (const ClaimCheck& check : setting.checks) {
            for (ClaimFinding& finding : findings(check, record.reason)) {
                outcomes.insert(finding.outcome);
                if (!setting.about.empty())
                    finding.about =
                        finding.about.empty() ? setting.about : setting.about + ": " + finding.about;
                record.findings.push_back(std::move(finding));
            }
            if (!record.reason.empty()) return ClaimRecord::kCannotTell;
            add_errors(check, record);
        }
        return outcomes.contains(ClaimRecord::kFails)        ? ClaimRecord::kFails
               : outcomes.contains(ClaimRecord::kCannotTell) ? ClaimRecord::kCannotTell
                                                             : ClaimRecord::kHolds;
    }

    std::vector<ClaimFinding> findings(const ClaimCheck& check, std::string& reason) {
        std::optional<std::vector<Found>> found = find_cells(check, check.quantity, reason);
        if (found && !check.cost.empty()) add_costs(check, *found, reason);
        if (!found || !reason.empty()) return {};
        std::vector<ClaimFinding> list;
        for (const Part& part : parts_of(check, *found)) list.push_back(finding(part, check));
        return list;
    }

    void add_costs(const ClaimCheck& check, std::vector<Found>& found, std::string& reason) const {
        const std::optional<std::vector<Found>> costs = find_cells(check, check.cost, reason);
        if (!costs) return;
        for (std::size_t i = 0; i < found.size(); ++i) found[i].cost = (*costs)[i].measured;
    }

    std::optional<std::vector<Found>> find_cells(const ClaimCheck& check, const std::string& quantity_id,
                                                 std::string& reason) const {
        const Quantity& quantity = find_quantity(quantity_id, "claims");
        std::vector<Found> list;
        for (const ClaimCell& asked : check.cells) {
            const ViewRecord* view = find_view(results_, list_.views.at(asked.view));
            std::vector<Measured> of_draws;
            const CellRecord* first = nullptr;
            for (const CellPlan& plan : asked.drawn()) {
                const CellRecord* cell = find_cell(view, cell_name(plan));
                if (first == nullptr) first = cell;
                Measured measured = measured_of(cell, view, asked, quantity);
                if (!measured.value) {
                    reason = why_not(cell, cell_name(plan), asked.view, quantity);
                    return std::nullopt;
                }
                of_draws.push_back(std::move(measured));
            }
            list.push_back({&asked, first, view, over_draws(of_draws, asked, results_.seed), {}});
        }
        return list;
    }

    const CellRecord* find_cell(const ViewRecord* view, const std::string& name) const {
        if (view == nullptr) return nullptr;
        const std::string id = view->key + "/" + name;
        const auto found = std::ranges::find(results_.cells, id, &CellRecord::id);
        return found == results_.cells.end() ? nullptr : &*found;
    }

    Measured measured_of(const CellRecord* cell, const ViewRecord* view, const ClaimCell& asked,
                         const Quantity& quantity) const {
        if (cell == nullptr || !cell->error.empty()) return {};
        const auto region = list_.regions.find(asked.view);
        if (region == list_.regions.end()) return quantity.measure(*cell, *view, results_.seed);
        return quantity.measure(within(region->second, *cell, *view), *view, results_.seed);
    }

    static std::string why_not(const CellRecord* cell, const std::string& name, const std::string& view,
                               const Quantity& quantity) {
        if (cell == nullptr) return fmt::format("{} {} on {}", kNotMeasured, name, view);
        if (!cell->error.empty()) return fmt::format("{} failed: {}", cell->id, cell->error);
        const std::string missing = fmt::format("{} has no {}", cell->id, quantity.label);
        return quantity.needs.timed() && !takes_times()
                   ? fmt::format("{}: {}, and none is kept", missing, times_elsewhere_text())
                   : missing;
    }

    static std::string name_of(const Found& found) {
        return fmt::format("{} ({})", found.cell->method_label, found.asked->label);
    }

    static std::vector<Measured> measured_of(const std::vector<Found>& found) {
        std::vector<Measured> list;
        for (const Found& one : found) list.push_back(one.measured);
        return list;
    }

    /// Each cell's quantity less that of the one before.
    std::vector<Part> successive_differences(const ClaimCheck& check, const Quantity& q,
                                             const std::vector<Found>& found) const {
        const auto difference = [](const std::vector<double>& v) { return v[1] - v[0]; };
        std::vector<Part> parts;
        for (std::size_t i = 0; i + 1 < found.size(); ++i) {
            parts.push_back(
                {fmt::format("{}: {} minus {}", q.label, name_of(found[i + 1]), name_of(found[i])),
                 combined({found[i].measured, found[i + 1].measured}, difference), -check.tolerance,
                 std::nullopt, std::string(q.unit), q.decimals});
        }
        return parts;
    }

    std::vector<Part> single_values(const ClaimCheck& check, const Quantity& q,
                                    const std::vector<Found>& found) const {
        std::vector<Part> parts;
        for (const Found& one : found)
            parts.push_back({fmt::format("{} of {}", q.label, name_of(one)), one.measured, check.low,
                             check.high, std::string(q.unit), q.decimals});
        return parts;
    }

    /// The first cell's quantity less what the others give at its cost.
    static Part beside_rivals(const ClaimCheck& check, const Quantity& q, const std::vector<Found>& found) {
        std::vector<Measured> all = measured_of(found);
        for (const Found& one : found) all.push_back(one.cost);
        const auto count = static_cast<std::ptrdiff_t>(found.size());
        const auto less_rivals = [count](const std::vector<double>& v) {
            const auto costs = v.begin() + count;
            return v[0] - at_cost(*costs, {costs + 1, v.end()}, {v.begin() + 1, costs});
        };
        return {
            fmt::format("{}: {} less that of {} to {} at the same {}", q.label, name_of(found[0]),
                        name_of(found[1]), name_of(found.back()), find_quantity(check.cost, "claims").label),
            combined(all, less_rivals),
            check.low,
            check.high,
            std::string(q.unit),
            q.decimals};
    }

    std::vector<Part> parts_of(const ClaimCheck& check, const std::vector<Found>& found) const {
        const Quantity& q = find_quantity(check.quantity, "claims");
        const std::string label(q.label), unit(q.unit);
        const std::vector<Measured> all = measured_of(found);
        const auto whole = [&](std::string what, auto f, std::string of_unit, int decimals) {
            return std::vector<Part>{
                {std::move(what), combined(all, f), check.low, check.high, std::move(of_unit), decimals}};
        };
        switch (check.kind) {
            case Kind::order:
            case Kind::monotone:
                return successive_differences(check, q, found);
            case Kind::ratio:
                return whole(
                    fmt::format("{}: {} divided by {}", label, name_of(found[0]), name_of(found[1])),
                    [](const auto& v) { return v[0] / v[1]; }, "", 3);
            case Kind::difference:
                return whole(
                    fmt::format("{}: {} minus {}", label, name_of(found[0]), name_of(found[1])),
                    [](const auto& v) { return v[0] - v[1]; }, unit, q.decimals);
            case Kind::ratio_difference:
                return whole(
                    fmt::format("{}: {} / {} minus {} / {}", label, name_of(found[0]), name_of(found[1]),
                                name_of(found[2]), name_of(found[3])),
                    [](const auto& v) { return v[0] / v[1] - v[2] / v[3]; }, "", 3);
            case Kind::slope: {
                std::vector<double> xs;
                for (const Found& one : found) xs.push_back(std::log(one.asked->x.value_or(1)));
                return whole(
                    fmt::format("slope of log {} from {} to {}", label, name_of(found.front()),
                                name_of(found.back())),
                    [xs](const auto& v) { return log_slope(xs, v); }, "", 3);
            }
            case Kind::value:
                return single_values(check, q, found);
            case Kind::spread:
                return whole(
                    fmt::format("spread of {} over {} cells, as a part of their mean", label, found.size()),
                    [](const auto& v) { return spread(v); }, "", 3);
            case Kind::gain:
                return whole(
                    fmt::format("{}: gain from {} to {} as a part of that from {} to {}", label,
                                found[2].asked->label, found[3].asked->label, found[0].asked->label,
                                found[1].asked->label),
                    [](const auto& v) { return (v[2] - v[3]) / (v[0] - v[1]); }, "", 3);
            case Kind::at_equal_cost:
                return {beside_rivals(check, q, found)};
        }
        return {};
    }

    static double log_slope(const std::vector<double>& log_x, const std::vector<double>& y) {
        const double n = static_cast<double>(y.size());
        double mean_x = 0, mean_y = 0, covariance = 0, variance = 0;
        for (std::size_t i = 0; i < y.size(); ++i) {
            mean_x += log_x[i] / n;
            mean_y += std::log(y[i]) / n;
        }
        for (std::size_t i = 0; i < y.size(); ++i) {
            covariance += (log_x[i] - mean_x) * (std::log(y[i]) - mean_y);
            variance += (log_x[i] - mean_x) * (log_x[i] - mean_x);
        }
        return covariance / variance;
    }

    static double spread(const std::vector<double>& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        double mean = 0;
        for (const double value : values) mean += value / static_cast<double>(values.size());
        return (*high - *low) / mean;
    }

    static ClaimFinding finding(const Part& part, const ClaimCheck& check) {
        ClaimFinding result;
        result.about = check.about;
        result.what = part.what;
        result.unit = part.unit;
        result.decimals = part.decimals;
        result.value = part.measured.value;
        result.claimed_low = part.low;
        result.claimed_high = part.high;
        result.outcome = ClaimRecord::kCannotTell;
        const std::optional<Range> range = part.measured.range();
        if (!range) return result;
        result.low = range->low;
        result.high = range->high;
        // Orders are strict: equal values are not less.
        const bool strict = check.kind == Kind::order;
        const auto above = [&](double v) {
            return !part.low || v > *part.low || (!strict && v == *part.low);
        };
        const auto below = [&](double v) { return !part.high || v <= *part.high; };
        const bool inside = above(range->low) && below(range->high);
        const bool outside = !above(range->high) || !below(range->low);
        result.outcome = inside    ? ClaimRecord::kHolds
                         : outside ? ClaimRecord::kFails
                                   : ClaimRecord::kCannotTell;
        return result;
    }

    // Adds the cells' errors against the truth, whatever the claim asks for.
    void add_errors(const ClaimCheck& check, ClaimRecord& record) const {
        for (const ClaimCell& asked : check.cells) {
            const ViewRecord* view = find_view(results_, list_.views.at(asked.view));
            if (view == nullptr) continue;
            const std::string id = view->key + "/" + cell_name(asked.plan);
            if (std::find(record.cell_ids.begin(), record.cell_ids.end(), id) == record.cell_ids.end())
                record.cell_ids.push_back(id);
        }
    }

    const ClaimList& list_;
    const Results& results_;
};

/// Says where the pictures of a view had another size before; empty where none had.
std::string other_size_text(const Results& now, const Results& before) {
    for (const ViewRecord& view : now.views) {
        const ViewRecord* earlier = find_row(before.views, view.key, &ViewRecord::key);
        if (earlier == nullptr || (earlier->width == view.width && earlier->height == view.height)) continue;
        return fmt::format(
            "measured at another size: {} {}x{}, before: {}x{}; verdicts may have changed by that alone\n",
            printable(view.key), view.width, view.height, earlier->width, earlier->height);
    }
    return {};
}

}  // namespace

std::vector<ClaimRecord> judge_claims(const std::vector<ClaimList>& lists, const Results& results) {
    std::vector<ClaimRecord> records;
    for (const ClaimList& list : lists) {
        Judge judge(list, results);
        for (const Claim& claim : list.claims) records.push_back(judge.judge(claim));
    }
    return records;
}

std::string verdict_text(const ClaimRecord& claim) {
    return fmt::format("{} {}: {} ({}, {})", claim.id, claim.verdict, claim.claim, claim.source, claim.place);
}

std::string verdict_table(const std::vector<ClaimRecord>& claims) {
    struct Counts {
        std::string source;
        std::map<std::string, std::size_t> by_verdict;
    };
    std::vector<Counts> lines;
    Counts all{"all", {}};
    for (const ClaimRecord& claim : claims) {
        auto line = std::ranges::find(lines, claim.source, &Counts::source);
        if (line == lines.end()) line = lines.insert(line, {claim.source, {}});
        ++line->by_verdict[claim.verdict];
        ++all.by_verdict[claim.verdict];
    }
    lines.push_back(all);
    std::string text;
    for (Counts& line : lines) {
        const std::size_t hold = line.by_verdict[ClaimRecord::kHolds],
                          fail = line.by_verdict[ClaimRecord::kFails],
                          open = line.by_verdict[ClaimRecord::kCannotTell];
        text += fmt::format("{:>4} judged: {:>3} hold, {:>3} do not, {:>3} cannot be told  {}\n",
                            hold + fail + open, hold, fail, open, printable(line.source));
    }
    return text;
}

std::string changed_verdicts(const Results& now, const Results& before) {
    std::string text;
    for (const ClaimRecord& claim : now.claims) {
        const ClaimRecord* earlier = find_row(before.claims, claim.id);
        if (earlier != nullptr && earlier->verdict == claim.verdict) continue;
        text += fmt::format("{} {}, before: {}\n", claim.id, claim.verdict,
                            earlier == nullptr ? "not judged" : printable(earlier->verdict));
    }
    if (text.empty()) text = "no verdict has changed\n";
    std::vector<std::string> left_out;
    for (const ClaimRecord& earlier : before.claims) {
        if (find_row(now.claims, earlier.id) == nullptr) left_out.push_back(printable(earlier.id));
    }
    if (!left_out.empty()) {
        text += fmt::format("judged before, and not now: {}\n", fmt::join(left_out, ", "));
    }
    return text + other_size_text(now, before);
}

}  // namespace aoscore
