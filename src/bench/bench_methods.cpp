#include "bench/bench_methods.h"

#include "bench/cost.h"
#include "core/counted.h"
#include "core/error.h"
#include "core/log.h"
#include "core/output.h"
#include "jobs/timing.h"
#include "plan/ranking_radius.h"
#include "screen/method/lengths.h"
#include "screen/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

namespace aoscore {
namespace {

constexpr char kDepthPass[] = "a pass of depth alone";

struct Row {
    std::string name;
    bool has_kernel = false;
    bool is_default = false;
    std::array<MethodRequest, 2> forms;  // specialised, uniform
    int rounds = 0;
    std::array<std::vector<double>, 2> runs_ms;
    std::vector<double> ratios;  // uniform over specialised, a round each
    double rms = 0, largest = 0;
};

std::vector<MethodDescriptor> chosen_methods(const MethodsBenchmark& benchmark) {
    std::vector<std::string> warnings;
    std::vector<MethodDescriptor> known =
        load_asked_methods(benchmark.methods_dir, benchmark.methods, warnings);
    for (const std::string& warning : warnings) log_warning(warning);
    if (benchmark.methods.empty()) return known;
    std::vector<MethodDescriptor> chosen;
    for (const std::string& id : benchmark.methods) chosen.push_back(find_method(known, id));
    return chosen;
}

// A pass that the program itself computes has no shader to specialise.
bool has_shaders(const MethodDescriptor& method) {
    return std::all_of(method.passes.begin(), method.passes.end(),
                       [](const Pass& pass) { return pass.processor.empty(); });
}

std::vector<Row> rows_of(const std::vector<MethodDescriptor>& methods, double radius_m, std::uint64_t seed) {
    std::vector<Row> rows;
    for (const MethodDescriptor& method : methods) {
        if (!has_shaders(method)) continue;
        for (const auto& [preset, values] : method.presets) {
            Row row;
            row.name = method.id + "/" + preset;
            row.has_kernel = !method.kernels.empty();
            row.is_default = preset == "default";
            MethodRequest request;
            request.method = &method;
            request.parameters = values_for_radius(method, radius_m, preset);
            request.seed = seed;
            row.forms = {request, request};
            row.forms[1].uniform_form = true;
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

void compare_pictures(ScreenRenderer& renderer, Row& row) {
    const ImageF specialised = renderer.run(row.forms[0]).raw, uniform = renderer.run(row.forms[1]).raw;
    double squares = 0;
    for (std::size_t i = 0; i < specialised.size(); ++i) {
        const double difference = std::abs(static_cast<double>(specialised.pixels[i] - uniform.pixels[i]));
        squares += difference * difference;
        row.largest = std::max(row.largest, difference);
    }
    row.rms = std::sqrt(squares / static_cast<double>(specialised.size()));
}

// Of all threads: what others do on the machine does not count.
double processor_ms(ScreenRenderer& renderer, const MethodRequest& request) {
    const std::clock_t start = std::clock();
    renderer.time(request);
    return 1000 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void time_round(ScreenRenderer& renderer, std::vector<Row>& rows, int round) {
    for (Row& row : rows) {
        if (round >= row.rounds) continue;
        std::array<double, 2> ms{};
        // Which form goes first alternates.
        for (const int turn : {0, 1}) {
            const auto form = static_cast<std::size_t>((turn + round) % 2);
            ms[form] = processor_ms(renderer, row.forms[form]);
            row.runs_ms[form].push_back(ms[form]);
        }
        row.ratios.push_back(ms[1] / ms[0]);
    }
}

double ratio(const Row& row) {
    return *summarize(row.ratios).median_ms;
}

void print_row(const Row& row) {
    print_result("{:<34} {:<7} {:>9.1f} {:>9.1f} {:>7.2f} ±{:<5.2f} {:>9.1e} {:>9.1e}\n", row.name,
                 row.has_kernel ? "kernel" : "-", *summarize(row.runs_ms[1]).median_ms,
                 *summarize(row.runs_ms[0]).median_ms, ratio(row), *summarize(row.ratios).spread_ms, row.rms,
                 row.largest);
    flush_output();
}

void add_to(RatioTable& table, const Row& row) {
    table.add(row.name, *summarize(row.runs_ms[0]).median_ms, kProcessorMs, kDepthPass);
    table.add(row.name + " with uniforms", *summarize(row.runs_ms[1]).median_ms, kProcessorMs, row.name);
}

/// Draws the scene's depth and nothing else; the fastest of some runs after a first.
double depth_pass_ms(ScreenRenderer& renderer, const CameraFrame& frame) {
    constexpr int kDraws = 10;
    renderer.draw_gbuffer(frame, {"linear_depth"});
    Cost least;
    for (int run = 0; run < kDraws; ++run)
        least.keep_least(cost_of([&] { renderer.draw_gbuffer(frame, {"linear_depth"}); }));
    return 1000 * least.processor_s;
}

void print_summary(const std::vector<Row>& rows) {
    std::vector<double> kernel_ratios;
    for (const Row& row : rows) {
        if (row.has_kernel && row.is_default) kernel_ratios.push_back(ratio(row));
    }
    const auto least = std::min_element(rows.begin(), rows.end(),
                                        [](const Row& a, const Row& b) { return ratio(a) < ratio(b); });
    if (!kernel_ratios.empty()) {
        print_result(
            "median over the {}, default presets: {:.2f} times faster\n",
            counted(kernel_ratios.size(), "method with a kernel table", "methods with kernel tables"),
            *summarize(kernel_ratios).median_ms);
    }
    if (least != rows.end()) print_result("least: {}, {:.2f} times\n", least->name, ratio(*least));
}

}  // namespace

void bench_methods(const Scene& scene, const View& view, const MethodsBenchmark& benchmark,
                   RatioTable& table) {
    const std::vector<MethodDescriptor> methods = chosen_methods(benchmark);
    std::vector<Row> rows = rows_of(methods, ranking_radius({}, view, scene).metres, benchmark.seed);
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    const CameraFrame frame(view.camera, benchmark.width, benchmark.height);
    table.add(kDepthPass, depth_pass_ms(renderer, frame), kProcessorMs);
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    print_result("{}/{}, {}x{}, {}; processor milliseconds\n", scene.id, view.id, benchmark.width,
                 benchmark.height, renderer.renderer());
    print_result("{:<34} {:<7} {:>9} {:>9} {:>7} {:<6} {:>9} {:>9}\n", "method/preset", "", "uniforms",
                 "constants", "ratio", "", "rms", "largest");
    int rounds = 0;
    for (Row& row : rows) {
        compare_pictures(renderer, row);
        row.rounds = timed_runs(processor_ms(renderer, row.forms[1]));
        rounds = std::max(rounds, row.rounds);
    }
    for (int round = 0; round < rounds; ++round) time_round(renderer, rows, round);
    for (const Row& row : rows) {
        print_row(row);
        add_to(table, row);
    }
    print_summary(rows);
    for (const Row& row : rows) {
        if (row.rms > kSamePicture) {
            throw internal_error(fmt::format("the two forms of {} differ by {:.1e} (rms), more than {:g}",
                                             row.name, row.rms, kSamePicture),
                                 "bench methods");
        }
    }
}

}  // namespace aoscore
