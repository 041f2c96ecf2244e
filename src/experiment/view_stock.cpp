#include "experiment/view_stock.h"

#include "core/error.h"
#include "core/hash.h"
#include "core/log.h"
#include "core/machine.h"
#include "core/threads.h"
#include "experiment/measuring_code.h"
#include "screen/request_digest.h"

#include <algorithm>
#include <set>
#include <span>

namespace aoscore {
namespace {

void add_camera(Digest& digest, const Camera& camera) {
    digest.value(camera.projection).value(camera.position).value(camera.target).value(camera.up);
    digest.value(camera.fovy_rad).value(camera.half_height).value(camera.near).value(camera.far);
}

void add_query(Digest& digest, const TruthQuery& query) {
    digest.value(query.falloff).value(query.radius_m).value(query.u_m);
}

// The albedo of surfaces without holes is not in the scene's digest: the truth does not see it.
std::string albedo_digest(const Scene& scene) {
    Digest digest;
    for (const Material& material : scene.materials) digest.value(material.texture);
    for (const Texture& texture : scene.textures) {
        digest.value(texture.texels.width).value(texture.texels.height);
        digest.array(std::span(texture.texels.pixels));
    }
    for (const Mesh& mesh : scene.meshes) digest.array(std::span(mesh.texcoords));
    return digest.hex();
}

/// What all measurements of a view have in common.
class ViewKey {
  public:
    ViewKey(const ViewRun& run, double radius_m) {
        const TruthSettings settings = truth_settings(run);
        Digest digest;
        digest.text(measuring_code())
            .text(run.tools.renderer().renderer())
            .text(run.tools.renderer().version());
        digest.text(run.scene.digest);
        add_camera(digest, run.view.camera);
        digest.value(run.plan.width).value(run.plan.height).value(radius_m).value(run.mask_threshold);
        digest.value(settings.samples).value(settings.max_error).value(settings.seed);
        digest.value(settings.extras.causes).value(settings.extras.one_layer_bound);
        digest.value(settings.extras.bent_normals);
        queries_ = wanted_queries(run, radius_m);
        // Where pixels are traced until all queries are sure, each of them changes the rays of the others.
        if (settings.max_error > 0) {
            for (const TruthQuery& query : queries_) add_query(digest, query);
        }
        base_ = digest.hex();
    }

    std::string cell(const ResolvedCell& cell, bool orthographic, const std::string& albedo) const {
        Digest digest;
        digest.text("cell").text(base_).text(request_digest(cell.request, orthographic));
        if (needed_gbuffer_inputs(cell.request).contains("albedo")) digest.text(albedo);
        digest.value(cell.plan.own_truth);
        if (cell.plan.own_truth) add_query(digest, cell.own);
        return digest.hex();
    }

    /// Of files that hold all queries, and what else they keep.
    std::string file(const char* what, const ViewRun& run, const std::string& albedo) const {
        Digest digest;
        digest.text(what).text(base_);
        for (const TruthQuery& query : queries_) add_query(digest, query);
        std::set<std::string> inputs = run.read_inputs();
        for (const std::string& input : inputs) digest.text(input);
        for (const std::string& input : run.kept_inputs) digest.text(input);
        inputs.insert(run.kept_inputs.begin(), run.kept_inputs.end());
        if (inputs.contains("albedo")) digest.text(albedo);
        return digest.hex();
    }

  private:
    std::string base_;
    std::vector<TruthQuery> queries_;
};

// Of times: what runs them, and all that is timed with the cell.
std::string times_key(const std::string& cell_key, const ResolvedCell& cell, const ViewRun& run,
                      bool orthographic) {
    Digest digest;
    digest.text("times").text(cell_key).text(cpu_name()).value(thread_count());
    digest.value(run.plan.timing_goal.has_value()).value(cell.plan.whole_frames);
    digest.text(request_digest(run.fixed_pass_request(), orthographic));
    return digest.hex();
}

// What a damaged or foreign entry holds counts as missing.
template <class Read>
auto read_entry(const MeasurementStore& store, const std::string& key, Read read)
    -> std::optional<decltype(read(nlohmann::json(), key))> {
    const std::optional<nlohmann::json> found = store.find(key);
    if (!found) return std::nullopt;
    try {
        return read(*found, key);
    } catch (const Error& e) {
        log_warning(std::string(e.what()) + "; measured again");
        return std::nullopt;
    }
}

}  // namespace

std::size_t ViewStock::missing() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) count += !has(i);
    return count;
}

std::vector<TruthQuery> wanted_queries(const ViewRun& run, double radius_m) {
    std::vector<TruthQuery> queries{{Falloff::binary, radius_m, 0}};
    for (const ResolvedCell& cell : run.cells) {
        if (cell.plan.own_truth && std::find(queries.begin(), queries.end(), cell.own) == queries.end())
            queries.push_back(cell.own);
    }
    return queries;
}

TruthSettings truth_settings(const ViewRun& run) {
    TruthSettings settings;
    settings.samples = run.plan.samples;
    settings.max_error = run.plan.max_error;
    settings.seed = run.seed;
    settings.extras = run.plan.extras;
    return settings;
}

ViewStock take_stock(const ViewRun& run, const MeasurementStore& store) {
    const ViewKey key(run, run.radius.metres);
    const bool orthographic = run.view.camera.projection == Camera::Projection::orthographic;
    const std::string albedo = albedo_digest(run.scene);
    ViewStock stock;
    stock.view_key = key.file("view", run, albedo);
    stock.truth_file_key = key.file("truth file", run, albedo);
    stock.gbuffer_file_key = key.file("G-buffer file", run, albedo);
    stock.view = read_entry(store, stock.view_key, view_record_from_json);
    for (const ResolvedCell& cell : run.cells) {
        const std::string of_cell = key.cell(cell, orthographic, albedo);
        stock.cell_keys.push_back(of_cell);
        stock.time_keys.push_back(times_key(of_cell, cell, run, orthographic));
        stock.image_keys.push_back(Digest().text("image").text(of_cell).hex());
        stock.cells.push_back(read_entry(store, of_cell, cell_record_from_json));
        stock.times.push_back(read_entry(store, stock.time_keys.back(), stored_times_from_json));
    }
    return stock;
}

}  // namespace aoscore
