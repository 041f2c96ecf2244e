#include "cli/command.h"
#include "cli/number_range.h"
#include "cli/outcome_options.h"
#include "compare/comparison.h"
#include "core/files.h"
#include "core/json_text.h"
#include "core/log.h"
#include "core/output.h"
#include "page/comparison_page.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>

namespace aoscore {
namespace {

struct CompareOptions {
    ComparisonRequest request;
    bool srgb = false, linear = false;
    std::string json;
    std::filesystem::path page;
    OutcomeOptions outcome;
};

PixelRect parse_crop(const std::string& text) {
    std::vector<int> numbers;
    const char *at = text.data(), *const end = at + text.size();
    for (;;) {
        int number = 0;
        const auto [next, ec] = std::from_chars(at, end, number);
        if (ec != std::errc()) break;
        numbers.push_back(number);
        at = next;
        if (at == end || *at != ',') break;
        ++at;
    }
    if (numbers.size() != 4 || at != end || numbers[0] < 0 || numbers[1] < 0 || numbers[2] < 1 ||
        numbers[3] < 1)
        throw CLI::ValidationError(
            "--crop", "\"" + text + "\" is no rectangle LEFT,TOP,WIDTH,HEIGHT such as 0,40,640,400");
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void print_line(const std::string& name, const std::string& value, const std::string& note = {}) {
    print_result("{:<16} {:>12}{}{}\n", name, value, note.empty() ? "" : "  ", note);
}

/// "[low, high]", the 95 % interval, or that there is none; empty for a measure that never has one.
std::string interval_text(const std::optional<ErrorAnalysis>& analysis, const std::string& id) {
    if (!analysis || !can_be_resampled(id)) return {};
    if (!analysis->intervals.contains(id)) return fmt::format("[{}]", kNoInterval);
    const Interval& interval = analysis->intervals.at(id);
    return fmt::format("[{:.6f}, {:.6f}]", interval.low, interval.high);
}

void print_table(const Comparison& comparison) {
    print_line("truth_channel", comparison.truth_channel, comparison.truth_channel_why);
    print_line("test_channel", comparison.test_channel, comparison.test_channel_why);
    const std::optional<ErrorAnalysis>& analysis = comparison.analysis;
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        const MeasuredMetric& measured = comparison.metrics.at(id);
        std::string note = measured.note;
        if (const std::string interval = interval_text(analysis, id); measured.value && !interval.empty())
            note += (note.empty() ? "" : " ") + interval;
        print_line(id, measured.value ? fmt::format("{:.6f}", *measured.value) : "-", note);
    }
    if (analysis) {
        for (const MaskArea& area : mask_areas()) {
            const std::string id(area.id);
            std::string note = interval_text(analysis, id);
            if (const auto noise = analysis->truth_noise.find(id); noise != analysis->truth_noise.end())
                note += fmt::format(" the truth's noise leaves it sure to {:.6f}", noise->second);
            print_line(id, fmt::format("{:.6f}", area.value(*analysis)), note);
        }
        print_line("fit_rmse", fmt::format("{:.6f}", analysis->fit.rmse),
                   fmt::format("at strength {:.3g} and exponent {:.3g}", analysis->fit.strength,
                               analysis->fit.exponent));
        for (const ErrorRegion& region : analysis->regions) {
            print_line(region.kind, fmt::format("{} px", region.area_px),
                       fmt::format("{}x{} at {}, {}; mean error {:.3f}, worst {:.3f} at {}, {}", region.width,
                                   region.height, region.left, region.top, region.mean_error,
                                   region.worst_error, region.worst_x, region.worst_y));
        }
    }
    print_line("valid_pixels", fmt::format("{}", comparison.valid_pixels));
    print_line("nonfinite", fmt::format("{}", comparison.nonfinite));
}

ExportTable export_table(const Comparison& comparison, const Gates::Tripped& tripped,
                         const std::string& title) {
    ExportTable table;
    table.title = title;
    table.name_columns = {"truth", "test"};
    add_measures(table);
    table.rows.push_back({comparison.request.test.string(),
                          {comparison.request.truth.string(), comparison.request.test.string()},
                          measures_of(comparison.metrics, comparison.analysis),
                          {},
                          comparison.sound() ? "" : "nothing could be compared",
                          tripped.failures});
    table.document = to_json(comparison);
    return table;
}

ComparisonPage page_of(const Comparison& comparison, const Gates::Tripped& tripped,
                       const std::string& command) {
    ComparisonPage page;
    page.command = command;
    page.truth = {comparison.request.truth.string(), comparison.truth_channel, comparison.truth_channel_why,
                  comparison.truth};
    page.test = {comparison.request.test.string(), comparison.test_channel, comparison.test_channel_why,
                 comparison.test};
    page.valid = comparison.valid;
    page.warnings = comparison.warnings;
    page.failures = tripped.failures;
    page.metrics = comparison.metrics;
    page.analysis = comparison.analysis;
    if (comparison.noise) page.noise_floor_rmse = comparison.noise->rmse();
    return page;
}

ExitCode run(CompareOptions options, const GlobalOptions& global) {
    Outcome outcome(options.outcome);
    if (options.srgb || options.linear) {
        options.request.truth_reading.coding = options.request.test_reading.coding =
            options.srgb ? Coding::srgb : Coding::linear;
    }
    options.request.seed = global.seed;
    const Comparison comparison = compare_images(options.request);
    const std::string where = options.request.test.string();
    for (const std::string& warning : comparison.warnings) log_warning(where + ": " + warning);
    const Gates::Tripped tripped =
        outcome.gates().check(limited_measures(comparison.metrics, comparison.analysis));
    if (options.json == "-") {
        print_result("{}\n", json_text(to_json(comparison), 2));
    } else {
        if (!options.json.empty()) write_atomically(options.json, json_text(to_json(comparison), 2) + "\n");
        print_table(comparison);
    }
    if (!options.page.empty())
        write_comparison_page(options.page, page_of(comparison, tripped, global.command_line));
    outcome.exports().write(export_table(comparison, tripped, global.command_line));
    if (!comparison.sound()) {
        log_error(fmt::format("aoscore: {}: {} valid pixels, {} NaN or infinite", where,
                              comparison.valid_pixels, comparison.nonfinite));
        return ExitCode::gate_failed;
    }
    if (comparison.noise) outcome.gates().require_above_noise(comparison.noise->rmse(), where);
    Outcome::print(tripped, where);
    Outcome::print_summary(tripped);
    return tripped.exit_code();
}

}  // namespace

CommandEntry add_compare_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand("compare",
                                           "Measure how far the visibility in TEST is from TRUTH: EXR, PNG, "
                                           "TIFF, HDR, ... of any engine. Without "
                                           "a channel's name it takes the only layer named AO, "
                                           "AmbientOcclusion, SSAO or the like, else the only picture "
                                           "in grey, and says so; never depth, nor one of several. mask.Y is "
                                           "honoured");
    const auto options = std::make_shared<CompareOptions>();
    ComparisonRequest& request = options->request;
    app->add_option("truth", request.truth, "The truth")->required();
    app->add_option("test", request.test, "The image under test")->required();
    app->add_option("--channel", request.test_reading.channel, "Of TEST, such as ViewLayer.AO.R [found]");
    app->add_option("--truth-channel", request.truth_reading.channel, "Of TRUTH, such as V1.Y [found]");
    CLI::Option* srgb = app->add_flag("--srgb", options->srgb,
                                      "8- and 16-bit files are sRGB-coded, as pictures for the screen are");
    app->add_flag("--linear", options->linear, "8- and 16-bit files are linear, as floats are")
        ->excludes(srgb);
    app->add_flag("--srgb-floats", request.test_reading.srgb_floats,
                  "TEST is sRGB-coded although it holds floats");
    app->add_flag("--flip", request.test_reading.flip, "TEST's rows run from the bottom up");
    app->add_flag("--mirror", request.test_reading.mirror, "TEST's columns run from right to left");
    app->add_flag("--invert", request.test_reading.invert, "TEST holds occlusion, not visibility");
    app->add_option_function<std::string>(
           "--crop", [&request](const std::string& text) { request.crop = parse_crop(text); },
           "Compare this part of the truth alone: its left column and its top row, counted from 0 at the "
           "upper left corner of the truth (of EXR's display window), then its width and height in pixels; "
           "TEST may be cropped to it already")
        ->type_name("LEFT,TOP,WIDTH,HEIGHT");
    app->add_option("--mask", request.mask, "An image of the truth's size: pixels above 1/2 count");
    app->add_option("--mask-channel", request.mask_channel, "Of the mask [mask.Y, or the only one]");
    app->add_option("--mask-threshold", request.mask_threshold,
                    "An error beyond this, in visibility, is missing or false occlusion; of a truth with a "
                    "standard error, the share of pixels that its noise adds is taken off. "
                    "Beyond 0 is every difference, by noise too")
        ->check(number_in(0.0, 1.0))
        ->capture_default_str();
    app->add_option("--json", options->json,
                    "Write one JSON object to this file, or to standard output for -");
    app->add_option("--page", options->page,
                    "Write one HTML page with both pictures, their error and every number");
    add_outcome_options(*app, options->outcome);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
