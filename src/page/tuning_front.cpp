#include "page/tuning_front.h"

#include "page/document/number_text.h"
#include "page/document/page_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace aoscore {
namespace {

constexpr double kWidth = 720, kHeight = 360, kLeft = 64, kRight = 200, kTop = 32, kBottom = 48;
constexpr double kLeastFetches = 0.5;  // of a method that fetches nothing, so that it has a place

bool is_beaten(const TunedPoint& point, const TunedPoint& by) {
    const bool no_worse = by.loss <= point.loss && by.fetches <= point.fetches;
    return no_worse && (by.loss < point.loss || by.fetches < point.fetches);
}

/// Between numbers and places in the chart.
class Scale {
  public:
    explicit Scale(const std::vector<TunedPoint>& points) {
        for (const TunedPoint& point : points) {
            const double at = log_of(point.fetches);
            low_ = std::min(low_, at);
            high_ = std::max(high_, at);
            most_ = std::max(most_, point.loss);
        }
        if (high_ - low_ < 1) {
            low_ -= 0.5;
            high_ += 0.5;
        }
        if (most_ <= 0) most_ = 1;
    }

    double x(double fetches) const {
        return kLeft + (log_of(fetches) - low_) / (high_ - low_) * (kWidth - kLeft - kRight);
    }
    double y(double loss) const { return kHeight - kBottom - loss / most_ * (kHeight - kTop - kBottom); }
    double most() const { return most_; }
    /// Powers of two within the points' fetches.
    std::vector<double> ticks() const {
        std::vector<double> ticks;
        for (double power = std::ceil(low_); power <= high_; ++power) ticks.push_back(std::exp2(power));
        return ticks;
    }

  private:
    static double log_of(double fetches) { return std::log2(std::max(fetches, kLeastFetches)); }
    double low_ = 1e9, high_ = -1e9, most_ = 0;
};

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                       escaped_html(text));
}

std::string axes_svg(const Scale& scale, const std::string& loss_label) {
    std::string svg = fmt::format("<path class=\"axis\" d=\"M{0} {1}V{2}H{3}\"/>", kLeft, kTop,
                                  kHeight - kBottom, kWidth - kRight);
    for (const double tick : scale.ticks())
        svg += text_at(scale.x(tick), kHeight - kBottom + 18, "middle", short_text(tick));
    for (const double part : {0.0, 0.5, 1.0}) {
        const double loss = part * scale.most();
        svg += text_at(kLeft - 8, scale.y(loss) + 4, "end", fixed_text(loss, 3));
    }
    svg += text_at((kLeft + kWidth - kRight) / 2, kHeight - 8, "middle", "fetches a pixel");
    return svg + text_at(8, 14, "start", loss_label);
}

/// Names to the right of the chart, from top to bottom, apart from each other, with a line to their points.
std::string names_svg(const std::map<std::string, std::pair<double, double>>& ends) {
    constexpr double kApart = 14;
    std::vector<std::pair<double, std::string>> sorted;
    for (const auto& [name, place] : ends) sorted.emplace_back(place.second, name);
    std::ranges::sort(sorted);
    std::string svg;
    double next = kTop;
    for (const auto& [y, name] : sorted) {
        next = std::max(next, y);
        const auto& [x, from] = ends.at(name);
        svg += fmt::format("<path class=\"leader\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", x + 5, from,
                           kWidth - kRight + 4, next);
        svg += text_at(kWidth - kRight + 8, next + 4, "start", name);
        next += kApart;
    }
    return svg;
}

}  // namespace

std::vector<TunedPoint> tuned_points(const TuningRecord& tuning) {
    std::vector<TunedPoint> points;
    for (const MethodTuningRecord& method : tuning.methods) {
        const std::string begun_from = method.label + ", " + method.preset;
        for (const BudgetRecord& budget : method.budgets) {
            if (&budget == &method.budgets.front())
                points.push_back(
                    {begun_from, begun_from, false, budget.published.fetches, budget.published.loss});
            points.push_back({method.label + ", " + budget.preset_id, begun_from, true, budget.tuned.fetches,
                              budget.tuned.loss});
        }
    }
    for (TunedPoint& point : points)
        point.on_front =
            std::ranges::none_of(points, [&](const TunedPoint& other) { return is_beaten(point, other); });
    return points;
}

std::string tuned_points_svg(const std::vector<TunedPoint>& points, const std::string& loss_label) {
    if (points.empty()) return "";
    const Scale scale(points);
    std::string marks;
    std::map<std::string, std::pair<double, double>> ends;  // of each method: its tuned point farthest right
    std::map<std::string, std::string> paths;
    for (const TunedPoint& point : points) {
        const double x = scale.x(point.fetches), y = scale.y(point.loss);
        std::string& path = paths[point.of_method];
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
        marks += fmt::format(
            "<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"><title>{}: {} at {} fetches"
            "</title></circle>",
            point.tuned ? "tuned" : "published", point.on_front ? " front" : "", x, y,
            escaped_html(point.name), fixed_text(point.loss, 4), fixed_text(point.fetches, 1));
        auto [end, is_new] = ends.try_emplace(point.of_method, x, y);
        if (!is_new && point.tuned && x >= end->second.first) end->second = {x, y};
    }
    std::string lines;
    for (const auto& [method, path] : paths) lines += fmt::format("<path class=\"joined\" d=\"{}\"/>", path);
    return fmt::format(
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Loss over fetches, published and "
        "tuned\">{}{}{}{}</svg>",
        kWidth, kHeight, axes_svg(scale, loss_label), lines, names_svg(ends), marks);
}

}  // namespace aoscore
