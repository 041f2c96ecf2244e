#include "core/error.h"
#include "reference/integrator/tile.h"
#include "scene/scene.h"
#include "store/truth/cache_file.h"
#include "store/truth/entry_lock.h"
#include "store/truth/tile_codec.h"
#include "store/truth/tracing_help.h"
#include "store/truth/truth_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

glm::dvec3 vector_from(const json& numbers) {
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

/// The inverse of TruthRequest::picture().
TruthRequest picture_from_json(const json& picture) {
    TruthRequest request;
    const json& camera = picture.at("camera");
    request.camera.projection = camera.at("projection") == "perspective" ? Camera::Projection::perspective
                                                                         : Camera::Projection::orthographic;
    request.camera.position = vector_from(camera.at("position"));
    request.camera.target = vector_from(camera.at("target"));
    request.camera.up = vector_from(camera.at("up"));
    request.camera.fovy_rad = camera.at("fovy_rad").get<double>();
    request.camera.half_height = camera.at("half_height").get<double>();
    request.camera.near = camera.at("near").get<double>();
    request.camera.far = camera.at("far").get<double>();
    request.scene_digest = picture.at("scene_digest").get<std::string>();
    request.width = picture.at("width").get<int>();
    request.height = picture.at("height").get<int>();
    request.settings.seed = picture.at("seed").get<std::uint64_t>();
    request.settings.shading_normals = picture.at("shading_normals").get<bool>();
    request.settings.points = static_cast<PointKind>(picture.at("points").get<int>());
    request.settings.skip_open = picture.at("skip_open").get<bool>();
    request.build.baked_triangles_at_most = picture.at("baked_triangles_at_most").get<std::size_t>();
    return request;
}

bool is_truth(const fs::path& path) {
    return path.extension() == ".truth" || path.extension() == ".partial";
}

/// The files of a cache, which has a folder for each picture, with its truths.
std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ec;
    for (const auto& picture : fs::directory_iterator(folder, ec)) {
        if (!picture.is_directory(ec)) continue;
        for (const auto& entry : fs::directory_iterator(picture.path(), ec)) {
            if (is_truth(entry.path())) files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The size of a file; 0 where there is no file.
std::uint64_t bytes_of(const fs::path& path) {
    std::error_code ec;
    const std::uintmax_t bytes = fs::file_size(path, ec);
    return ec ? 0 : bytes;
}

CacheEntry describe(const fs::path& path) {
    CacheEntry entry;
    entry.file = path;
    std::error_code ec;
    entry.bytes = bytes_of(path);
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(path, ec);
    entry.age_s = std::max(0.0, std::chrono::duration<double>(age).count());
    try {
        const CacheFile file(path, CacheFile::Mode::read);
        const json& header = file.header();
        entry.request = request_from_json(header.at("wanted"), picture_from_json(header.at("picture")));
        entry.label = {header.at("scene").get<std::string>(), header.at("view").get<std::string>(),
                       header.at("command").get<std::string>()};
        entry.groups = header.at("groups").get<std::size_t>();
        entry.groups_done = file.groups();
        entry.damaged_bytes = file.damaged_bytes();
        entry.complete = file.finished() && entry.groups_done == entry.groups;
        entry.current = entry.request.picture() == header.at("picture");
        entry.readable = true;
    } catch (const std::exception&) {
        entry.damaged_bytes = entry.bytes;
    }
    return entry;
}

}  // namespace

std::vector<CacheEntry> TruthCache::list() const {
    std::vector<CacheEntry> entries;
    for (const fs::path& path : files_of(folder_)) entries.push_back(describe(path));
    return entries;
}

CacheVerdict TruthCache::verify(const CacheEntry& entry, std::size_t groups) {
    CacheVerdict verdict;
    if (!entry.readable || !entry.current) {
        verdict.not_traced = entry.readable ? "traced by another version" : "unreadable";
        return verdict;
    }
    std::optional<Scene> scene;
    try {
        scene = load_scene(entry.label.scene);
    } catch (const Error& e) {
        verdict.not_traced = e.what();
        return verdict;
    }
    if (scene->digest != entry.request.scene_digest) {
        verdict.not_traced = entry.label.scene + " is another scene now";
        return verdict;
    }
    const CacheFile file(entry.file, CacheFile::Mode::read);
    std::vector<std::size_t> numbers;
    const std::size_t step = std::max<std::size_t>(1, entry.groups / std::max<std::size_t>(1, groups));
    for (std::size_t g = step / 2; g < entry.groups && numbers.size() < groups; g += step) {
        if (file.has(g)) numbers.push_back(g);
    }
    const TruthRequest& request = entry.request;
    const std::vector<GroupState> again =
        ReferenceScene(*scene, request.build)
            .trace_groups(CameraFrame(request.camera, request.width, request.height), request.queries,
                          request.settings, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const GroupState kept = decode(file.read(numbers[i]), entry.file.string());
        ++verdict.groups_compared;
        if (kept.tiles != again[i].tiles) ++verdict.groups_differing;
    }
    return verdict;
}

ClearedCache TruthCache::clear() const {
    ClearedCache cleared;
    std::error_code ec;
    for (const fs::path& path : files_of(folder_)) {
        const std::optional<EntryLock> lock =
            EntryLock::try_acquire(fs::path(path).replace_extension(".lock"));
        if (!lock) {
            ++cleared.kept_in_use;
            continue;
        }
        const std::uint64_t bytes = bytes_of(path);
        fs::remove_all(path, ec);
        if (ec) throw file_error("cannot be removed: " + ec.message(), path.string());
        for (const char* beside : {".salvage", ".search"})
            fs::remove(fs::path(path).replace_extension(beside), ec);
        ++cleared.files;
        cleared.bytes += bytes;
    }
    for (const auto& picture : fs::directory_iterator(folder_, ec)) {
        if (!picture.is_directory(ec)) continue;
        for (const auto& entry : fs::directory_iterator(picture.path(), ec)) {
            if (is_tracing_help(entry.path())) fs::remove(entry.path(), ec);
        }
        fs::remove(picture.path(), ec);  // succeeds only where it is empty
    }
    return cleared;
}

}  // namespace aoscore
