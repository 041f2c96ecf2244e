#include "plan/sweep.h"

#include "core/error.h"
#include "core/image_size.h"
#include "core/known_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace aoscore {
namespace {

std::string word(const ParameterValue& value, const std::string& axis) {
    if (!value.is_word()) throw usage_error("\"" + value.text() + "\" is no name", "vary " + axis);
    return value.word();
}

/// One point of the product: its values on the axes, and those of them that apply.
struct Point {
    CellPlan cell;
    std::optional<ImageSize> size;
    ParameterValues at;
};

constexpr const char* kNobodyHas = "nothing in this sweep has a parameter";

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
        taken_.assign(request_.set.size(), false);
        for (const std::string& id : request_.methods) add_method(find_method(registry_.methods, id));
        check_taken();
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
        for (const SweepAxis& axis : request_.axes) {
            if (!known.contains(axis.id))
                throw unknown_name(kNobodyHas, axis.id, {known.begin(), known.end()}, "vary " + axis.id);
            for (const Assignment& one : request_.set) {
                if (one.parameter == axis.id) throw usage_error(axis.id + " is set and varied", "set");
            }
        }
    }

    /// Checks that some cell has each parameter that is set.
    void check_taken() const {
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            if (taken_[i]) continue;
            const std::string& id = request_.set[i].parameter;
            throw unknown_name(kNobodyHas, id,
                               assignable_parameters(cells_, registry_.methods, registry_.filters),
                               "set " + id);
        }
    }

    void note(const std::string& text) {
        if (std::find(sweep_.notes.begin(), sweep_.notes.end(), text) == sweep_.notes.end())
            sweep_.notes.push_back(text);
    }

    void add_method(const MethodDescriptor& method) {
        Point start;
        start.cell = request_.base;
        start.cell.method = method.id;
        expand(method, start, 0);
    }

    void expand(const MethodDescriptor& method, const Point& point, std::size_t axis_index) {
        if (axis_index == request_.axes.size()) return add_point(point);
        const SweepAxis& axis = request_.axes[axis_index];
        bool applies = true;
        for (const ParameterValue& value : axis.values) {
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

    // Sets the value of one axis. False where the axis does not apply to this method with the values set
    // before.
    bool set(const MethodDescriptor& method, Point& point, const std::string& id,
             const ParameterValue& value) const {
        if (id == "preset") {
            point.cell.preset = word(value, id);
        } else if (id == "filter") {
            point.cell.filter = word(value, id);
            if (*point.cell.filter != "none") find_method(registry_.filters, *point.cell.filter);
        } else if (id == "size") {
            point.size = parse_image_size(word(value, id), "vary size");
        } else if (const RunModeOption* mode = find_row(run_mode_options(), id)) {
            mode->choose(point.cell.modes, value.text());
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
                              const std::string& id, const ParameterValue& value) {
        const Parameter* parameter = owner.find_parameter(id);
        if (parameter == nullptr) return false;
        if (!parameter->accepts(value))
            throw usage_error(fmt::format("{} of {} cannot be {}", id, owner.id, value.quoted()),
                              "vary " + id, parameter->valid());
        overrides[id] = value;
        return true;
    }

    void add_point(Point point) {
        // Assignments come last, when the cell's filter is known.
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            if (assign(request_.set[i], registry_.methods, registry_.filters, point.cell)) taken_[i] = true;
        }
        cells_.push_back(point.cell);
        ViewPlan wanted = view_;
        wanted.cells.clear();
        // What a method over several layers is for: the occlusion that no method over one can find.
        const MethodDescriptor& method = find_method(registry_.methods, point.cell.method);
        wanted.extras.one_layer_bound |= method.depth_layers || method.side_layers;
        if (point.size) {
            wanted.width = point.size->width;
            wanted.height = point.size->height;
        }
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
    std::vector<bool> taken_;      ///< for each assignment of the request whether a cell has the parameter
    std::vector<CellPlan> cells_;  ///< cells of all points
};

}  // namespace

SweepAxis parse_axis(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw usage_error("\"" + text + "\" varies nothing", "--vary", "parameter=value,value,...");
    SweepAxis axis{text.substr(0, equals), {}};
    for (std::size_t begin = equals + 1; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (end == begin) throw usage_error("\"" + text + "\" has an empty value", "--vary");
        const ParameterValue value = parse_value(text.substr(begin, end - begin));
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
