#include "experiment/sweep.h"

#include "core/error.h"
#include "core/image.h"
#include "core/known_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace aoscore {
namespace {

using nlohmann::json;

const RunModeOption* find_mode(const std::string& id) {
    const auto& modes = run_mode_options();
    const auto found = std::find_if(modes.begin(), modes.end(), [&](const auto& m) { return m.id == id; });
    return found == modes.end() ? nullptr : &*found;
}

std::string word(const json& value, const std::string& axis) {
    if (!value.is_string()) throw usage_error("\"" + value.dump() + "\" is no name", "vary " + axis);
    return value.get<std::string>();
}

std::pair<int, int> parse_size(const std::string& text) {
    int width = 0, height = 0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, width);
    bool good = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
    if (good) {
        const auto second = std::from_chars(first.ptr + 1, end, height);
        good = second.ec == std::errc() && second.ptr == end;
    }
    if (!good || width < 1 || height < 1 || width > kLargestImageSide_px || height > kLargestImageSide_px) {
        throw usage_error("\"" + text + "\" is no size", "vary size",
                          fmt::format("such as 1920x1080, at most {} each way", kLargestImageSide_px));
    }
    return {width, height};
}

/// What one point of the product asks for, and what of it applies.
struct Point {
    CellPlan cell;
    std::optional<std::pair<int, int>> size;
    std::map<std::string, json> at;
};

class Expansion {
  public:
    Expansion(ExperimentPlan& plan, const ViewPlan& view, const SweepRequest& request, SweepPlan& sweep,
              const Registry& registry)
        : plan_(plan), view_(view), request_(request), sweep_(sweep), registry_(registry) {}

    void add_all() {
        for (const SweepAxis& axis : request_.axes) {
            if (std::find(sweep_.axes.begin(), sweep_.axes.end(), axis.id) == sweep_.axes.end())
                sweep_.axes.push_back(axis.id);
        }
        check_axes();
        for (const std::string& id : request_.methods) add_method(find_method(registry_.methods, id));
    }

  private:
    void check_axes() const {
        std::set<std::string> known{"preset", "filter", "size"};
        for (const RunModeOption& mode : run_mode_options()) known.emplace(mode.id);
        for (const std::string& id : request_.methods) {
            for (const Parameter& p : find_method(registry_.methods, id).parameters) known.insert(p.id);
        }
        for (const MethodDescriptor& filter : registry_.filters) {
            for (const Parameter& p : filter.parameters) known.insert(std::string(kFilterPrefix) + p.id);
        }
        const auto check = [&](const std::string& id) {
            if (known.contains(id)) return;
            throw unknown_name("nothing in this sweep has a parameter", id, {known.begin(), known.end()},
                               "vary " + id);
        };
        for (const SweepAxis& axis : request_.axes) check(axis.id);
        for (const auto& [id, value] : request_.base.overrides) check(id);
    }

    void note(const std::string& text) {
        if (std::find(sweep_.notes.begin(), sweep_.notes.end(), text) == sweep_.notes.end())
            sweep_.notes.push_back(text);
    }

    void add_method(const MethodDescriptor& method) {
        Point start;
        start.cell = request_.base;
        start.cell.method = method.id;
        std::erase_if(start.cell.overrides,
                      [&](const auto& entry) { return method.find_parameter(entry.first) == nullptr; });
        expand(method, start, 0);
    }

    void expand(const MethodDescriptor& method, const Point& point, std::size_t axis_index) {
        if (axis_index == request_.axes.size()) return add_point(point);
        const SweepAxis& axis = request_.axes[axis_index];
        bool applies = true;
        for (const json& value : axis.values) {
            Point next = point;
            applies = set(method, next, axis.id, value);
            if (!applies) break;
            if (axis.id == "preset" && !method.presets.contains(next.cell.preset)) {
                note(fmt::format("{} has no preset {}", method.label, next.cell.preset));
                continue;
            }
            next.at[axis.id] = value;
            expand(method, next, axis_index + 1);
        }
        if (!applies) {
            note(fmt::format("{}: {} does not apply and is left out", method.label, axis.id));
            expand(method, point, axis_index + 1);
        }
    }

    // False where the axis means nothing for this method and what was chosen before.
    bool set(const MethodDescriptor& method, Point& point, const std::string& id, const json& value) const {
        if (id == "preset") {
            point.cell.preset = word(value, id);
        } else if (id == "filter") {
            point.cell.filter = word(value, id);
            if (*point.cell.filter != "none") find_method(registry_.filters, *point.cell.filter);
        } else if (id == "size") {
            point.size = parse_size(word(value, id));
        } else if (const RunModeOption* mode = find_mode(id)) {
            const std::string choice = word(value, id);
            if (std::find(mode->choices.begin(), mode->choices.end(), choice) == mode->choices.end())
                throw unknown_name("no " + id, choice, mode->choices, "vary " + id);
            mode->choose(point.cell.modes, choice);
        } else if (id.starts_with(kFilterPrefix)) {
            const std::string filter = filter_of(point.cell, method).filter;
            if (filter == "none") return false;
            return set_parameter(find_method(registry_.filters, filter), point.cell.filter_overrides,
                                 id.substr(kFilterPrefix.size()), value);
        } else {
            return set_parameter(method, point.cell.overrides, id, value);
        }
        return true;
    }

    static bool set_parameter(const MethodDescriptor& owner, ParameterValues& overrides,
                              const std::string& id, const json& value) {
        const Parameter* parameter = owner.find_parameter(id);
        if (parameter == nullptr) return false;
        if (!parameter->accepts(value))
            throw usage_error(fmt::format("{} of {} cannot be {}", id, owner.id, value.dump()), "vary " + id,
                              parameter->valid());
        overrides[id] = value;
        return true;
    }

    void add_point(const Point& point) {
        ViewPlan wanted = view_;
        wanted.cells.clear();
        if (point.size) std::tie(wanted.width, wanted.height) = *point.size;
        SweepPoint added;
        added.view_index = shared_view(plan_, wanted);
        added.cell_index = shared_cell(plan_.views[added.view_index], point.cell);
        added.at = point.at;
        added.at["method"] = point.cell.method;
        sweep_.points.push_back(std::move(added));
    }

    ExperimentPlan& plan_;
    const ViewPlan& view_;
    const SweepRequest& request_;
    SweepPlan& sweep_;
    const Registry& registry_;
};

json parse_value(const std::string& text) {
    json value = json::parse(text, nullptr, false);
    const bool plain = value.is_number() || value.is_boolean();
    return plain ? value : json(text);
}

}  // namespace

SweepAxis parse_axis(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw usage_error("\"" + text + "\" varies nothing", "--vary", "parameter=value,value,...");
    SweepAxis axis{text.substr(0, equals), {}};
    for (std::size_t begin = equals + 1; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (end == begin) throw usage_error("\"" + text + "\" has an empty value", "--vary");
        const json value = parse_value(text.substr(begin, end - begin));
        if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end())
            throw usage_error("\"" + text + "\" has a value twice", "--vary");
        axis.values.push_back(value);
        begin = end + 1;
    }
    return axis;
}

void add_sweep(ExperimentPlan& plan, const ViewPlan& view, const SweepRequest& request, SweepPlan& sweep,
               const Registry& registry) {
    Expansion(plan, view, request, sweep, registry).add_all();
}

}  // namespace aoscore
