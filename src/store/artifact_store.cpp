#include "store/artifact_store.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "core/json_text.h"
#include "core/log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kPlace = "place";  ///< member with the path of a file that is not copied into the store
constexpr const char* kFileDigest = "file_digest";

std::string digest_of(const std::string& bytes) {
    return Digest().text(bytes).hex();
}

/// Whether the file is there and has these bytes.
bool holds(const fs::path& file, const std::string& digest) {
    std::error_code ec;
    return fs::is_regular_file(file, ec) && digest_of(read_file(file)) == digest;
}

/// The payload of an entry's file. Throws file_error where it differs from the one that was put under the
/// key.
json checked_payload(const fs::path& path, const std::string& key) {
    const json entry = json::parse(read_file(path), nullptr, false);
    const bool whole = entry.is_object() && entry.value("key", "") == key && entry.contains("payload") &&
                       entry.value("digest", "") == digest_of(json_text(entry.at("payload")));
    if (!whole) throw file_error("is damaged", path.string());
    return entry.at("payload");
}

}  // namespace

fs::path ArtifactStore::folder_in(const fs::path& cache) {
    return cache.empty() ? fs::path() : cache / "measurements";
}

fs::path ArtifactStore::entry(const std::string& key, const std::string& extension) const {
    return folder_ / key.substr(0, 2) / (key + extension);
}

std::optional<json> ArtifactStore::find(const std::string& key) const {
    if (!enabled()) return std::nullopt;
    const fs::path path = entry(key, ".json");
    std::error_code ec;
    if (!fs::exists(path, ec)) return std::nullopt;
    try {
        return checked_payload(path, key);
    } catch (const Error& e) {
        log_warning(fmt::format("{}; measured again", e.what()));
        return std::nullopt;
    }
}

void ArtifactStore::put(const std::string& key, const json& payload) const {
    if (!enabled()) return;
    const json wrapped = {{"key", key}, {"digest", digest_of(json_text(payload))}, {"payload", payload}};
    keep(entry(key, ".json"), json_text(wrapped));
}

void ArtifactStore::require_writable() const {
    const fs::path probe = folder_ / fmt::format("probe-{}", getpid());
    write_atomically(probe, "");
    std::error_code ec;
    fs::remove(probe, ec);
}

void ArtifactStore::keep(const fs::path& file, const std::string& bytes) const {
    try {
        write_atomically(file, bytes);
    } catch (const Error& e) {
        if (e.exit_code() != ExitCode::file_error) throw;
        if (!std::exchange(warned_, true))
            log_warning(fmt::format("measurements are not kept: {}", e.what()));
    }
}

bool ArtifactStore::has(const std::string& key) const {
    std::error_code ec;
    return enabled() && fs::exists(entry(key, ".json"), ec);
}

std::optional<fs::path> ArtifactStore::file(const std::string& key) const {
    const std::optional<json> facts = find(key);
    if (!facts) return std::nullopt;
    const std::string digest = facts->value(kFileDigest, "");
    if (facts->contains(kPlace)) {
        const fs::path place = facts->at(kPlace).get<std::string>();
        return holds(place, digest) ? std::optional(place) : std::nullopt;
    }
    const fs::path path = entry(key, facts->value("extension", ""));
    try {
        if (digest_of(read_file(path)) != digest) throw file_error("is damaged", path.string());
        return path;
    } catch (const Error& e) {
        log_warning(fmt::format("{}; made again", e.what()));
        return std::nullopt;
    }
}

bool ArtifactStore::fetch_file(const std::string& key, const fs::path& target) const {
    const std::optional<fs::path> path = file(key);
    if (!path) return false;
    write_atomically(target, read_file(*path));
    placed_.emplace_back(key, target);
    return true;
}

void ArtifactStore::put_file(const std::string& key, const fs::path& source) const {
    if (!enabled()) return;
    const std::string bytes = read_file(source);
    const std::string extension = source.extension().string();
    keep(entry(key, extension), bytes);
    put(key, {{"extension", extension}, {kFileDigest, digest_of(bytes)}});
    placed_.emplace_back(key, source);
}

void ArtifactStore::settle(const fs::path& staged, const fs::path& published) const {
    for (const auto& [key, file] : std::exchange(placed_, {})) {
        std::optional<json> facts = find(key);
        if (!facts || !facts->is_object()) continue;
        const fs::path place = fs::absolute(published / file.lexically_relative(staged)).lexically_normal();
        const fs::path copy = entry(key, facts->value("extension", ""));
        if (facts->value(kPlace, "") == place.string()) continue;
        std::error_code ec;
        if (holds(place, facts->value(kFileDigest, ""))) {
            (*facts)[kPlace] = place.string();
            put(key, *facts);
        } else {
            fs::remove(entry(key, ".json"), ec);
        }
        fs::remove(copy, ec);
    }
}

ArtifactStore::Size ArtifactStore::size() const {
    Size size;
    if (!enabled() || !fs::is_directory(folder_)) return size;
    for (const auto& file : fs::recursive_directory_iterator(folder_)) {
        if (!file.is_regular_file()) continue;
        size.entries += file.path().extension() == ".json";
        size.bytes += file.file_size();
    }
    return size;
}

ArtifactStore::Size ArtifactStore::clear() const {
    const Size size_before = size();
    std::error_code ec;
    if (enabled()) fs::remove_all(folder_, ec);
    if (ec) throw file_error("cannot be removed: " + ec.message(), folder_.string());
    return size_before;
}

std::vector<fs::path> ArtifactStore::damaged() const {
    std::vector<fs::path> paths;
    if (!enabled() || !fs::is_directory(folder_)) return paths;
    for (const auto& file : fs::recursive_directory_iterator(folder_)) {
        if (file.path().extension() != ".json") continue;
        const std::string key = file.path().stem().string();
        try {
            const json payload = checked_payload(file.path(), key);
            if (!payload.is_object() || !payload.contains(kFileDigest)) continue;
            if (payload.contains(kPlace)) continue;  // the file belongs to its owner
            const fs::path image = entry(key, payload.value("extension", ""));
            if (digest_of(read_file(image)) != payload.at(kFileDigest)) paths.push_back(image);
        } catch (const Error&) {
            paths.push_back(file.path());
        }
    }
    return paths;
}

}  // namespace aoscore
