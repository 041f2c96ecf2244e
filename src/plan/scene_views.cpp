#include "plan/scene_views.h"

#include "framing/automatic_views.h"
#include "scene/scene_frame.h"
#include "scene/view_choice.h"
#include "store/key.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

std::string views_key(const Scene& scene, double aspect) {
    return KeyBuilder("views").text(scene.digest).value(aspect).key().hex;
}

json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 vector_of(const json& numbers) {
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

json to_json(const View& view) {
    const Camera& camera = view.camera;
    return {{"id", view.id},
            {"position", numbers(camera.position)},
            {"target", numbers(camera.target)},
            {"up", numbers(camera.up)},
            {"fovy_rad", camera.fovy_rad},
            {"near", camera.near},
            {"far", camera.far},
            {"radius_m", view.radius_m ? json(*view.radius_m) : json()},
            {"note", view.note}};
}

View view_of(const json& stored) {
    Camera camera;
    camera.position = vector_of(stored.at("position"));
    camera.target = vector_of(stored.at("target"));
    camera.up = vector_of(stored.at("up"));
    camera.fovy_rad = stored.at("fovy_rad");
    camera.near = stored.at("near");
    camera.far = stored.at("far");
    View view = automatic_view_of(stored.at("id"), camera);
    if (!stored.at("radius_m").is_null()) view.radius_m = stored.at("radius_m").get<double>();
    view.note = stored.at("note");
    return view;
}

std::vector<View> kept_automatic_views(const Scene& scene, double aspect, const ArtifactStore& store) {
    const std::string key = views_key(scene, aspect);
    std::vector<View> views;
    if (const auto found = store.find(key)) {
        for (const json& stored : *found) views.push_back(view_of(stored));
        return views;
    }
    views = automatic_views(scene, aspect);
    json payload = json::array();
    for (const View& view : views) payload.push_back(to_json(view));
    store.put(key, payload);
    return views;
}

}  // namespace

std::vector<View> wanted_views(const Scene& scene, const LoadOptions& loaded_with, const std::string& choice,
                               double aspect, const ArtifactStore& store) {
    const bool is_stated =
        std::ranges::any_of(scene.views, [&](const View& view) { return view.id == choice; });
    const bool is_automatic = !is_stated && (choice.starts_with("auto") || scene.views.empty());
    if (!is_automatic) return choose_views(scene.id, scene.views, choice);
    std::vector<View> views = kept_automatic_views(scene, aspect, store);
    for (View& view : views) view.options += frame_options(loaded_with);
    return choose_views(scene.id, views, choice);
}

std::string no_camera_text(const Scene& scene, const std::vector<View>& views) {
    if (!scene.views.empty() || views.empty()) return {};
    return fmt::format("{} has no camera: taking {} (a camera of your own: --eye and --target, or --views)",
                       scene.id,
                       views.size() == 1 ? "the automatic view " + views.front().id
                                         : fmt::format("{} automatic views", views.size()));
}

}  // namespace aoscore
