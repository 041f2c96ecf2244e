#include "page/index_results.h"

#include <fmt/format.h>

namespace aoscore::testing {
namespace {

/// A number in [0,1) that depends on both.
double mixed(int a, int b) {
    return static_cast<double>((a * 7919 + b * 104729 + 12345) % 1000) / 1000;
}

CellRecord cell_of(const ViewRecord& view, int method, double error) {
    CellRecord cell;
    cell.id = fmt::format("{}/m{}/default", view.key, method);
    cell.view_key = view.key;
    cell.method = fmt::format("m{}", method);
    cell.method_label = fmt::format("Method {}", method);
    cell.preset = "default";
    cell.filter = "box-4x4";
    cell.ao.median_ms = 1.0 + method;
    cell.fetches_per_pixel = 8 * (method + 1);
    cell.ranked = {{"rmse_debiased", {error, ""}}, {"bias", {-error / 4, ""}}};
    return cell;
}

Results results_of_scene(int scene, int views, int methods) {
    Results results;
    results.created_utc = "2026-01-02T03:04:05Z";
    for (int v = 0; v < views; ++v) {
        ViewRecord& view = results.views.emplace_back();
        view.scene = fmt::format("scene-{:03}", scene);
        view.view = fmt::format("view-{}", v);
        view.key = view.scene + "/" + view.view;
        view.width = 320;
        view.height = 180;
        view.radius_m = 0.5;
        for (int m = 0; m < methods; ++m) {
            const double error = 0.02 * (m + 1) * (1 + 0.1 * mixed(scene, v));
            CellRecord& cell = results.cells.emplace_back(cell_of(view, m, error));
            if (m == methods - 1 && v == 0) cell.error = "7 pixels are NaN or infinite";
        }
    }
    return results;
}

}  // namespace

IndexBuilder synthetic_index(int scenes, int views, int methods) {
    IndexBuilder index("index");
    for (int scene = 0; scene < scenes; ++scene)
        index.add(results_of_scene(scene, views, methods), "nowhere");
    return index;
}

}  // namespace aoscore::testing
