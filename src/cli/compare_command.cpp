#include "cli/command.h"
#include "core/files.h"
#include "experiment/gate.h"
#include "metrics/evaluate.h"
#include "metrics/metric.h"
#include "metrics/occlusion_masks.h"
#include "results/image_file.h"

#include <fmt/format.h>

#include <memory>

namespace aoscore {
namespace {

struct Options {
    std::filesystem::path truth, test;
    std::string json;
    bool srgb = false;
    double mask_threshold = 0.1;
    std::vector<std::string> fail, warn;
};

struct Comparison {
    MetricMap metrics;
    OcclusionMasks masks;
    std::size_t valid_pixels = 0;
    std::size_t nonfinite = 0;
};

Comparison compare(const Options& options) {
    const VisibilityFile truth = read_visibility(options.truth, options.srgb);
    const VisibilityFile test = read_visibility(options.test, options.srgb);
    if (!truth.visibility.same_size(test.visibility)) {
        throw Error(ExitCode::sizes_differ,
                    fmt::format("truth is {}x{}, test is {}x{}", truth.visibility.width,
                                truth.visibility.height, test.visibility.width, test.visibility.height),
                    options.test.string(), "images of one size");
    }
    Mask candidate = truth.mask;
    for (std::size_t i = 0; i < candidate.size(); ++i) candidate.pixels[i] &= test.mask.pixels[i];

    Comparison result;
    const Mask valid = finite_pixels(truth.visibility, test.visibility, candidate, result.nonfinite);
    for (const auto pixel : valid.pixels) result.valid_pixels += pixel;
    const MetricInput input{truth.visibility, test.visibility, valid,
                            truth.standard_error.empty() ? nullptr : &truth.standard_error};
    result.metrics = evaluate(input);
    result.masks = occlusion_masks(input, options.mask_threshold);
    return result;
}

nlohmann::json to_json(const Comparison& comparison, const Options& options) {
    nlohmann::json metrics = nlohmann::json::object();
    for (const auto& [id, metric] : comparison.metrics) {
        metrics[id] = {{"value", metric.value ? nlohmann::json(*metric.value) : nlohmann::json()}};
        if (!metric.note.empty()) metrics[id]["note"] = metric.note;
    }
    const bool any = comparison.valid_pixels > 0;
    const auto area = [&](double value) { return any ? nlohmann::json(value) : nlohmann::json(); };
    return {{"truth", options.truth.string()},
            {"test", options.test.string()},
            {"valid_pixels", comparison.valid_pixels},
            {"nonfinite", comparison.nonfinite},
            {"metrics", metrics},
            {"masks",
             {{"threshold", options.mask_threshold},
              {"missing_area", area(comparison.masks.missing_area)},
              {"false_area", area(comparison.masks.false_area)}}}};
}

void print_table(const Comparison& comparison) {
    for (const Metric& metric : metrics()) {
        const auto found = comparison.metrics.find(std::string(metric.id));
        if (found == comparison.metrics.end()) continue;
        const MeasuredMetric& measured = found->second;
        fmt::print("{:<16} {:>12}  {}\n", metric.id,
                   measured.value ? fmt::format("{:.6f}", *measured.value) : "-", measured.note);
    }
    if (comparison.valid_pixels > 0) {
        fmt::print("{:<16} {:>12.6f}\n{:<16} {:>12.6f}\n", "missing_area", comparison.masks.missing_area,
                   "false_area", comparison.masks.false_area);
    }
    fmt::print("{:<16} {:>12}\n{:<16} {:>12}\n", "valid_pixels", comparison.valid_pixels, "nonfinite",
               comparison.nonfinite);
}

bool any_tripped(const std::vector<Gate>& gates, const MetricMap& metrics, const char* kind) {
    bool tripped = false;
    for (const Gate& gate : gates) {
        if (!gate.tripped_by(metrics)) continue;
        fmt::print(stderr, "{} {}\n", kind, gate.explain(metrics));
        tripped = true;
    }
    return tripped;
}

std::vector<Gate> parse_gates(const std::vector<std::string>& texts) {
    std::vector<Gate> gates;
    for (const std::string& text : texts) gates.push_back(Gate::parse(text));
    return gates;
}

ExitCode run(const Options& options) {
    const std::vector<Gate> fail = parse_gates(options.fail), warn = parse_gates(options.warn);
    const Comparison comparison = compare(options);
    if (options.json == "-") {
        fmt::print("{}\n", to_json(comparison, options).dump(2));
    } else {
        if (!options.json.empty())
            write_atomically(options.json, to_json(comparison, options).dump(2) + "\n");
        print_table(comparison);
    }
    if (comparison.valid_pixels == 0 || comparison.nonfinite > 0) {
        fmt::print(stderr, "aoscore: {}: {} valid pixels, {} NaN or infinite\n", options.test.string(),
                   comparison.valid_pixels, comparison.nonfinite);
        return ExitCode::gate_failed;
    }
    if (any_tripped(fail, comparison.metrics, "fail")) return ExitCode::gate_failed;
    if (any_tripped(warn, comparison.metrics, "warn")) return ExitCode::warned;
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_compare_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand(
        "compare",
        "Measure how far the visibility in TEST is from TRUTH (EXR, PNG, ...; any engine's image)");
    const auto options = std::make_shared<Options>();
    app->add_option("truth", options->truth,
                    "The truth: Y, the only channel, or equal R, G, B; mask.Y is honoured")
        ->required();
    app->add_option("test", options->test, "The image under test")->required();
    app->add_option("--json", options->json,
                    "Write one JSON object to this file, or to standard output for -");
    app->add_flag("--srgb", options->srgb, "8-bit files are sRGB-coded [they are value/255]");
    app->add_option("--mask-threshold", options->mask_threshold,
                    "Of missing and false occlusion, in visibility")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    app->add_option("--fail", options->fail, "Exit with 2 when this holds: rmse>0.02 (also without a value)");
    app->add_option("--warn", options->warn, "Exit with 1 when this holds: ssim<0.9");
    return {app, [options] { return run(*options); }};
}

}  // namespace aoscore
