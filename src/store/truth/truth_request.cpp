#include "store/truth/truth_request.h"

#include "core/hash.h"
#include "core/json_text.h"
#include "reference/sampling/sample_plan.h"
#include "store/code_digest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

using nlohmann::json;

json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

json camera_json(const Camera& camera) {
    return {
        {"projection", camera.projection == Camera::Projection::perspective ? "perspective" : "orthographic"},
        {"position", numbers(camera.position)},
        {"target", numbers(camera.target)},
        {"up", numbers(camera.up)},
        {"fovy_rad", camera.fovy_rad},
        {"half_height", camera.half_height},
        {"near", camera.near},
        {"far", camera.far}};
}

/// The query as JSON, which has no infinity.
json query_json(const TruthQuery& query) {
    return {{"falloff", kFalloffIds[static_cast<std::size_t>(query.falloff)]},
            {"radius_m", std::isfinite(query.radius_m) ? json(query.radius_m) : json()},
            {"u_m", query.u_m}};
}

TruthQuery query_from(const json& object) {
    TruthQuery query;
    const auto falloff = object.at("falloff").get<std::string>();
    query.falloff = static_cast<Falloff>(std::ranges::find(kFalloffIds, falloff) - kFalloffIds.begin());
    const json& radius = object.at("radius_m");
    query.radius_m = radius.is_null() ? std::numeric_limits<double>::infinity() : radius.get<double>();
    query.u_m = object.at("u_m").get<double>();
    return query;
}

std::string key_of(const json& value) {
    return Digest().text(json_text(value)).hex();
}

}  // namespace

json TruthRequest::picture() const {
    return {{"code", code_digest("truth")},
            {"tracer", tracer_version()},
            {"scene_digest", scene_digest},
            {"camera", camera_json(camera)},
            {"width", width},
            {"height", height},
            {"seed", settings.seed},
            {"shading_normals", settings.shading_normals},
            {"points", static_cast<int>(settings.points)},
            {"skip_open", settings.skip_open},
            {"baked_triangles_at_most", build.baked_triangles_at_most}};
}

json TruthRequest::wanted() const {
    json list = json::array();
    for (const TruthQuery& query : queries) list.push_back(query_json(query));
    return {{"queries", std::move(list)},
            {"causes", settings.extras.causes},
            {"one_layer_bound", settings.extras.one_layer_bound},
            {"bent_normals", settings.extras.bent_normals},
            {"samples", settings.samples},
            {"max_error", settings.max_error},
            {"mean_error", settings.mean_error}};
}

std::string TruthRequest::picture_key() const {
    return key_of(picture());
}

std::string TruthRequest::wanted_key() const {
    return key_of(wanted());
}

TruthRequest request_from_json(const json& wanted, const TruthRequest& of_same_picture) {
    TruthRequest request = of_same_picture;
    request.queries.clear();
    for (const json& query : wanted.at("queries")) request.queries.push_back(query_from(query));
    request.settings.extras = {wanted.at("causes").get<bool>(), wanted.at("one_layer_bound").get<bool>(),
                               wanted.at("bent_normals").get<bool>()};
    request.settings.samples = wanted.at("samples").get<int>();
    request.settings.max_error = wanted.at("max_error").get<double>();
    request.settings.mean_error = wanted.at("mean_error").get<double>();
    return request;
}

bool serves(const TruthRequest& have, const TruthRequest& want) {
    const auto has = [&](const TruthQuery& query) {
        return std::ranges::find(have.queries, query) != have.queries.end();
    };
    if (!std::ranges::all_of(want.queries, has)) return false;
    const TruthExtras &there = have.settings.extras, &asked = want.settings.extras;
    if (asked.any() && have.queries[0] != want.queries[0]) return false;
    if ((asked.causes && !there.causes) || (asked.one_layer_bound && !there.one_layer_bound) ||
        (asked.bent_normals && !there.bent_normals)) {
        return false;
    }
    const auto within = [](double error, double limit) { return error > 0 && error <= limit; };
    const double every = want.settings.max_error, mean = want.settings.mean_error;
    if (every > 0 && !within(have.settings.max_error, every)) return false;
    if (mean > 0 && !within(have.settings.max_error, mean) && !within(have.settings.mean_error, mean))
        return false;
    return SamplePlan(have.settings).first() >= SamplePlan(want.settings).first();
}

bool can_begin(const TruthRequest& have, const TruthRequest& want) {
    return have.queries == want.queries && have.settings.extras == want.settings.extras &&
           SamplePlan(have.settings).first() <= SamplePlan(want.settings).first();
}

}  // namespace aoscore
