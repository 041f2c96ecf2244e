#include "jobs/view_keys.h"

#include "core/node_kind.h"
#include "metrics/analysis/repeats.h"
#include "screen/method/request_digest.h"
#include "store/code_digest.h"

#include <vector>

namespace aoscore {
namespace {

// The digest of the albedo of surfaces without holes, which is not in the scene's digest: no truth depends on
// it.
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

// The key of these queries of the requested truth.
Key truth_key(TruthRequest request, std::span<const TruthQuery> queries) {
    // Where pixels are traced until all queries converge, each query changes the rays of the others.
    if (request.settings.max_error == 0) request.queries.assign(queries.begin(), queries.end());
    KeyBuilder key("truth");
    key.text(request.picture_key()).text(request.wanted_key()).value(request.settings.halves);
    for (const TruthQuery& query : queries) key.value(query.falloff).value(query.radius_m).value(query.u_m);
    return key.key();
}

}  // namespace

bool ViewKeys::orthographic() const {
    return work_.view.camera.projection == Camera::Projection::orthographic;
}

const std::string& ViewKeys::albedo() const {
    if (!albedo_) albedo_ = albedo_digest(work_.scene);
    return *albedo_;
}

const std::string& ViewKeys::fixed_pass() const {
    if (!fixed_pass_) fixed_pass_ = request_digest(work_.fixed_pass, orthographic());
    return *fixed_pass_;
}

const std::string& ViewKeys::environment() const {
    if (!environment_) environment_ = work_.environment->digest();
    return *environment_;
}

Key ViewKeys::gbuffer(const std::set<std::string>& inputs) const {
    KeyBuilder key("gbuffer", "image");
    key.text(work_.gl_renderer).text(work_.gl_version).text(work_.scene.digest).camera(work_.view.camera);
    key.value(work_.width).value(work_.height);
    for (const std::string& input : inputs) key.text(input);
    if (inputs.contains("albedo")) key.text(albedo());
    return key.key();
}

// Begins the key of an artifact with times, which depend on the machine.
KeyBuilder ViewKeys::timed(std::string_view kind) const {
    KeyBuilder key(kind, "times");
    key.text(timed_on());
    return key;
}

Key ViewKeys::gbuffer_times() const {
    return timed("gbuffer_times").input(gbuffer(work_.read_inputs())).key();
}

Key ViewKeys::truth(std::span<const TruthQuery> queries) const {
    return truth_key(work_.truth_request(), queries);
}

// The extras of the view's truth belong to its first query, and do not count here.
Key ViewKeys::own_truth(const TruthQuery& query) const {
    if (work_.ranks_by(query)) return truth(std::vector<TruthQuery>{work_.queries.front(), query});
    return truth_key(work_.own_truth_request(), std::span(&query, 1));
}

Key ViewKeys::own_truths() const {
    return truth_key(work_.own_truth_request(), work_.own_queries);
}

// The contract depends only on the truth's primary hits, which no number of rays changes.
Key ViewKeys::contract() const {
    TruthRequest request = work_.truth_request();
    return KeyBuilder("contract").text(request.picture_key()).input(gbuffer({})).key();
}

Key ViewKeys::view() const {
    KeyBuilder key("view");
    key.input(truth(work_.queries)).input(contract()).value(work_.radius_m);
    return key.key();
}

Key ViewKeys::truth_file() const {
    return KeyBuilder("truth_file", "files").input(truth(work_.queries)).input(contract()).key();
}

Key ViewKeys::gbuffer_file() const {
    KeyBuilder key("gbuffer_file", "files");
    key.input(gbuffer(work_.drawn_inputs()));
    if (work_.keeps_surfaces()) key.text("surfaces");
    return key.key();
}

Key ViewKeys::image(const CellWork& cell) const {
    const auto [found, is_new] = images_.try_emplace(&cell);
    if (is_new) {
        const Contestant& contestant = *cell.contestant;
        KeyBuilder key("image", contestant.code());
        key.text(code_digest("files")).value(work_.width).value(work_.height);
        if (const auto inputs = contestant.gbuffer_inputs()) key.input(gbuffer(*inputs));
        if (const auto query = contestant.truth_query()) key.input(own_truth(*query));
        found->second = key.text(contestant.digest(orthographic())).key();
    }
    return found->second;
}

Key ViewKeys::score(const CellWork& cell) const {
    KeyBuilder key("score");
    key.input(image(cell)).input(truth(std::span(work_.queries).first(1))).input(contract());
    key.value(work_.mask_threshold).value(work_.seed).value(work_.untold);
    return key.key();
}

Key ViewKeys::own_score(const CellWork& cell) const {
    KeyBuilder key("own_score", "score");
    return key.input(image(cell)).input(own_truth(cell.own.value())).input(contract()).key();
}

Key ViewKeys::fetches(const CellWork& cell) const {
    return KeyBuilder("fetches", "image").input(image(cell)).input(contract()).key();
}

Key ViewKeys::irradiance() const {
    KeyBuilder key("irradiance");
    key.text(code_digest("files")).text(work_.scene.digest).camera(work_.view.camera);
    key.value(work_.width).value(work_.height).value(work_.radius_m).value(work_.seed);
    return key.text(environment()).key();
}

Key ViewKeys::view_light() const {
    KeyBuilder key("view_light", "light");
    key.input(irradiance()).input(truth(std::span(work_.queries).first(1))).input(contract());
    return key.key();
}

// Of the truth it takes the normals alone, which no number of rays changes.
Key ViewKeys::light(const CellWork& cell) const {
    return KeyBuilder("light").input(image(cell)).input(irradiance()).input(contract()).key();
}

Key ViewKeys::lit_file(const CellWork& cell) const {
    return KeyBuilder("lit_file", "files").text(code_digest("light")).input(light(cell)).key();
}

Key ViewKeys::repeats(const CellWork& cell) const {
    KeyBuilder key("repeats");
    key.input(image(cell)).input(truth(std::span(work_.queries).first(1))).input(contract());
    key.value(Repeats::kSeeds);
    if (cell.converged) key.text(request_digest(*cell.converged, orthographic()));
    return key.key();
}

Key ViewKeys::times(const CellWork& cell) const {
    KeyBuilder key = timed("times");
    key.input(image(cell)).text(fixed_pass()).value(cell.whole_frames);
    if (cell.whole_frames) key.text(request_digest(cell.timed, orthographic()));
    return key.key();
}

}  // namespace aoscore
