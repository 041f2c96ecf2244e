#include "reference/tracer/scene_builds.h"

#include <utility>

namespace aoscore {
namespace {

/// A part with more of the scene's triangles than this saves too little: the next picture may see the rest.
constexpr double kLargestPart = 0.8;

bool has_all(const std::vector<char>& there, const std::vector<char>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (wanted[i] != 0 && there[i] == 0) return false;
    }
    return true;
}

}  // namespace

const Reach& SceneBuilds::reach() {
    if (!reach_) reach_.emplace(*scene_);
    return *reach_;
}

std::uint64_t SceneBuilds::triangles_of(const std::vector<char>& instances) const {
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const auto mesh = static_cast<std::size_t>(scene_->instances[i].mesh);
        if (instances[i] != 0) triangles += scene_->meshes[mesh].triangles.size();
    }
    return triangles;
}

const RayTracer& SceneBuilds::add(std::vector<char> instances, double rays) {
    auto tracer = new_ray_tracer(*scene_, build_, instances, rays);
    return *built_.emplace_back(Built{std::move(instances), std::move(tracer)}).tracer;
}

void SceneBuilds::build_whole() {
    const std::scoped_lock lock(mutex_);
    reach();  // for later pictures, when the scene may be gone
    add(std::vector<char>(scene_->instances.size(), 1), std::numeric_limits<double>::infinity());
}

ReachableScene SceneBuilds::reachable(const CameraFrame& frame, double reach_m, double rays) {
    const std::scoped_lock lock(mutex_);
    std::vector<char> within = reach().instances(frame, reach_m);
    const std::vector<char> all(within.size(), 1);
    const std::vector<char>& wanted = build_.leave_out_of_reach ? within : all;
    for (const Built& built : built_) {
        if (has_all(built.instances, wanted)) return {*built.tracer, std::move(within)};
    }
    const std::uint64_t whole = triangles_of(all), part = triangles_of(wanted);
    // All parts together are no more than the whole scene: pictures from everywhere cost no more than twice
    // what building it at once does.
    const bool pays = static_cast<double>(part) < kLargestPart * static_cast<double>(whole) &&
                      triangles_in_parts_ + part <= whole;
    if (!pays) return {add(all, rays), std::move(within)};
    const RayTracer& tracer = add(wanted, rays);
    triangles_in_parts_ += part;
    return {tracer, std::move(within), whole - part};
}

std::size_t SceneBuilds::peak_bytes() const {
    const std::scoped_lock lock(mutex_);
    std::size_t bytes = 0;
    for (const Built& built : built_) bytes += built.tracer->peak_bytes();
    return bytes;
}

}  // namespace aoscore
