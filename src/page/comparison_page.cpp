#include "page/comparison_page.h"

#include "core/files.h"
#include "core/folders.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/bootstrap.h"
#include "metrics/roles.h"
#include "page/document/html_document.h"
#include "page/document/number_text.h"
#include "page/document/page_parts.h"
#include "page/document/page_template.h"
#include "page/pictures/coloured_picture.h"
#include "page/pictures/thumbnail.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kWidest_px = 1200;
constexpr int kGrays = 255, kErrorSteps = 63;
constexpr double kErrorRange = 0.5;

json image_model(const ComparedImage& image) {
    return {{"file", image.file},
            {"channel", image.channel},
            {"why", image.why},
            {"picture", coloured_picture({&image.visibility}, 0, 1, gray_palette(kGrays))}};
}

/// Test minus truth where they were compared, NaN elsewhere.
ImageF error_of(const ComparisonPage& comparison) {
    ImageF error(comparison.valid.width, comparison.valid.height, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < error.size(); ++i) {
        if (comparison.valid.pixels[i] == 0) continue;
        error.pixels[i] = comparison.test.visibility.pixels[i] - comparison.truth.visibility.pixels[i];
    }
    return error;
}

json row(const std::string& id, const std::string& label, std::optional<double> value, int decimals,
         const std::string& meaning, const std::optional<ErrorAnalysis>& analysis) {
    std::string interval = value && can_be_resampled(id) ? kNoInterval : "";
    if (analysis && analysis->intervals.contains(id)) {
        const Interval& found = analysis->intervals.at(id);
        interval = fmt::format("{} to {}", fixed_text(found.low, decimals), fixed_text(found.high, decimals));
    }
    return {{"label", label},
            {"value", fixed_text(value, decimals)},
            {"interval", interval},
            {"meaning", meaning}};
}

json rows_model(const ComparisonPage& comparison) {
    json rows = json::array();
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        const auto found = comparison.metrics.find(id);
        if (found == comparison.metrics.end()) continue;
        const std::string note = found->second.note.empty() ? "" : " (" + found->second.note + ")";
        const std::string unit = metric.unit.empty() ? "" : ", " + std::string(metric.unit);
        rows.push_back(row(id, std::string(metric.label) + unit, found->second.value, metric.decimals,
                           std::string(metric.meaning) + note, comparison.analysis));
    }
    if (!comparison.analysis) return rows;
    for (const MaskArea& area : mask_areas()) {
        rows.push_back(row(
            std::string(area.id), std::string(area.label) + " occlusion", area.value(*comparison.analysis), 4,
            fmt::format("Share of the pixels that are {} than the truth by more than the threshold; where "
                        "the truth's standard error is known, without those that its noise adds.",
                        area.side),
            comparison.analysis));
    }
    return rows;
}

std::string verdict(const ComparisonPage& comparison) {
    const auto value = [&](const char* id) {
        const auto found = comparison.metrics.find(id);
        return found == comparison.metrics.end() ? std::nullopt : found->second.value;
    };
    const std::optional<double> error = value(kNoisyRankingMetric), bias = value(kBiasMetric);
    if (!error || !bias) return "Nothing could be compared.";
    return fmt::format("The image’s {} against the truth is {}; it is {} by {} in the mean.",
                       metric(kNoisyRankingMetric).in_text, fixed_text(error, 4),
                       *bias < 0 ? "too dark" : "too bright", fixed_text(std::abs(*bias), 4));
}

}  // namespace

void write_comparison_page(const fs::path& path, const ComparisonPage& comparison) {
    const fs::path parts = data_dir() / "reports" / "comparison";
    ComparisonPage shown = comparison;
    const ImageF error = shrunk(error_of(comparison), kWidest_px);
    for (ComparedImage* image : {&shown.truth, &shown.test})
        image->visibility = shrunk(image->visibility, kWidest_px);
    std::size_t valid = 0;
    for (const auto pixel : comparison.valid.pixels) valid += pixel;
    const json model = {
        {"version", std::string(version())},
        {"verdict", verdict(comparison)},
        {"images", json::array({image_model(shown.truth), image_model(shown.test)})},
        {"error", coloured_picture({&error}, -kErrorRange, kErrorRange, blue_red_palette(kErrorSteps))},
        {"error_range", short_text(kErrorRange)},
        {"warnings", comparison.warnings},
        {"failures", comparison.failures},
        {"rows", rows_model(comparison)},
        {"noise", comparison.noise_floor_rmse ? fixed_text(comparison.noise_floor_rmse, 4) : ""},
        {"valid", count_text(valid)},
        {"size", fmt::format("{}x{}", comparison.valid.width, comparison.valid.height)},
        {"command", comparison.command}};
    const fs::path frame = parts / "template.html";
    write_atomically(
        path, html_text({"comparison",
                         read_file(page_folder() / "style" / "page.css") + read_file(parts / "style.css"), "",
                         fill_template(read_file(frame), model, frame.string())}));
}

}  // namespace aoscore
