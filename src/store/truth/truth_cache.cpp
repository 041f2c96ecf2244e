#include "store/truth/truth_cache.h"

#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "reference/sample_plan.h"
#include "reference/tile.h"
#include "store/truth/cache_file.h"
#include "store/truth/entry_lock.h"
#include "store/truth/tile_codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kComplete = ".truth";
constexpr const char* kPartial = ".partial";
constexpr const char* kLock = ".lock";
constexpr const char* kSalvage = ".salvage";

fs::path with(const fs::path& stem, const char* extension) {
    return fs::path(stem) += extension;
}

/// A cache file as a store of tiles; puts nothing into a file that is only read.
class FileStore final : public TileStore {
  public:
    FileStore(CacheFile& file, const CacheFile* base, std::string where)
        : file_(file), base_(base), where_(std::move(where)) {}

    bool has(std::size_t group) const override { return file_.has(group); }
    GroupState load(std::size_t group) const override { return decode(file_.read(group), where_); }
    GroupState begun(std::size_t group) const override {
        return base_ != nullptr && base_->has(group) ? decode(base_->read(group), where_) : GroupState{};
    }
    void keep(std::size_t group, const GroupState& state) override {
        if (failed_) return;
        try {
            file_.append(group, encode(state));
        } catch (const Error& e) {
            if (e.exit_code() != ExitCode::file_error) throw;
            if (!failed_.exchange(true)) log_warning(fmt::format("the truth is not kept: {}", e.what()));
        }
    }
    bool failed() const { return failed_; }

  private:
    CacheFile& file_;
    const CacheFile* base_;
    std::string where_;
    std::atomic<bool> failed_{false};
};

/// A complete file of the cache.
struct OpenTruth {
    fs::path path;
    TruthRequest request;
    std::unique_ptr<CacheFile> file;
};

json header_of(const TruthRequest& request, const TruthLabel& label, std::size_t groups) {
    return {{"picture", request.picture()},
            {"wanted", request.wanted()},
            {"scene", label.scene},
            {"view", label.view},
            {"command", label.command},
            {"version", version()},
            {"groups", groups}};
}

/// Takes what is good of a damaged truth as the beginning of a new one.
void set_aside(const fs::path& path, const std::string& why) {
    log_warning(fmt::format("{}: {}; what is damaged is thrown away and traced anew", path.string(), why));
    std::error_code ec;
    fs::rename(path, fs::path(path).replace_extension(kPartial), ec);
}

/// All complete truths of the request's picture; damaged ones are set aside.
std::vector<OpenTruth> complete_truths(const fs::path& folder, const TruthRequest& request) {
    std::vector<fs::path> paths;
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(folder, ec)) {
        if (entry.path().extension() == kComplete) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<OpenTruth> truths;
    for (const fs::path& path : paths) {
        try {
            auto file = std::make_unique<CacheFile>(path, CacheFile::Mode::read);
            if (file->damaged_bytes() > 0 || !file->finished() ||
                file->groups() != file->header().at("groups").get<std::size_t>()) {
                set_aside(path, fmt::format("{} bytes are damaged", file->damaged_bytes()));
                continue;
            }
            TruthRequest made_for = request_from_json(file->header().at("wanted"), request);
            truths.push_back({path, std::move(made_for), std::move(file)});
        } catch (const std::exception& e) {
            // Another process may have replaced it by a better one meanwhile.
            if (fs::exists(path, ec)) set_aside(path, e.what());
        }
    }
    return truths;
}

std::optional<CachedTruth> served(const std::vector<OpenTruth>& truths, const CameraFrame& frame,
                                  const TruthRequest& want) {
    const OpenTruth* best = nullptr;
    for (const OpenTruth& truth : truths) {
        if (!serves(truth.request, want)) continue;
        // The very one, if it is there: the same command gives the same picture.
        if (best == nullptr || truth.request.wanted() == want.wanted()) best = &truth;
    }
    if (best == nullptr) return std::nullopt;
    std::vector<std::size_t> which;
    for (const TruthQuery& query : want.queries) {
        const auto& queries = best->request.queries;
        which.push_back(static_cast<std::size_t>(std::ranges::find(queries, query) - queries.begin()));
    }
    const FileStore store(*best->file, nullptr, best->path.string());
    CachedTruth cached;
    cached.truth =
        kept_truth(frame, best->request.queries, best->request.settings, which, want.settings.extras, store);
    cached.origin = TruthOrigin::cached;
    cached.made_for = best->request;
    return cached;
}

/// The truth with most rays that the wanted one can go on from.
const OpenTruth* base_of(const std::vector<OpenTruth>& truths, const TruthRequest& want) {
    const OpenTruth* best = nullptr;
    for (const OpenTruth& truth : truths) {
        if (!can_begin(truth.request, want)) continue;
        if (best == nullptr ||
            SamplePlan(truth.request.settings).first() > SamplePlan(best->request.settings).first()) {
            best = &truth;
        }
    }
    return best;
}

/// The good groups of a damaged file, in a file of its name.
std::unique_ptr<CacheFile> salvaged(const CacheFile& damaged, const fs::path& path) {
    const fs::path temporary = fs::path(path).replace_extension(kSalvage);
    auto file = std::make_unique<CacheFile>(temporary, damaged.header());
    const auto groups = damaged.header().at("groups").get<std::size_t>();
    for (std::size_t g = 0; g < groups; ++g) {
        if (damaged.has(g)) file->append(g, damaged.read(g));
    }
    fs::rename(temporary, path);
    return file;
}

/// What an interrupted run left, or a new file.
std::unique_ptr<CacheFile> open_partial(const fs::path& path, const json& header) {
    std::error_code ec;
    if (fs::exists(path, ec)) {
        try {
            auto file = std::make_unique<CacheFile>(path, CacheFile::Mode::append);
            if (file->damaged_bytes() > 0) {
                log_warning(fmt::format("{}: {} bytes are damaged or incomplete and thrown away",
                                        path.string(), file->damaged_bytes()));
                file = salvaged(*file, path);
            }
            if (file->header().at("picture") == header.at("picture") &&
                file->header().at("wanted") == header.at("wanted")) {
                return file;
            }
        } catch (const std::exception& e) {
            log_warning(fmt::format("{}: {}; it is thrown away", path.string(), e.what()));
            if (!fs::is_regular_file(path, ec)) fs::remove_all(path, ec);
        }
    }
    return std::make_unique<CacheFile>(path, header);
}

}  // namespace

std::string_view origin_id(TruthOrigin origin) {
    switch (origin) {
        case TruthOrigin::traced:
            return "traced";
        case TruthOrigin::resumed:
            return "resumed";
        case TruthOrigin::refined:
            return "refined";
        case TruthOrigin::cached:
            return "cached";
    }
    return "";
}

std::string scene_name(const Scene& scene) {
    return scene.file.empty() ? scene.id : fs::absolute(scene.file).string();
}

fs::path default_cache_dir() {
    if (const char* dir = std::getenv("AOSCORE_CACHE"); dir != nullptr && *dir != '\0') return dir;
    return home_dir() / "references" / "cache";
}

CachedTruth TruthCache::trace(const ReferenceScene& reference, const TruthRequest& request,
                              const TruthLabel& label, const std::string& what) const {
    check_truth_request(request.queries, request.settings);
    const CameraFrame frame(request.camera, request.width, request.height);
    const auto uncached = [&] { return trace_truth({}, reference, request, label, what); };
    const fs::path folder = folder_ / request.picture_key();
    const fs::path stem = folder / request.wanted_key();
    if (std::optional<CachedTruth> there = served(complete_truths(folder, request), frame, request)) {
        log_info(what + ": from the cache");
        return std::move(*there);
    }
    std::optional<EntryLock> lock;
    std::unique_ptr<CacheFile> file;
    std::vector<OpenTruth> truths;
    try {
        fs::create_directories(folder);
        lock.emplace(EntryLock::acquire(with(stem, kLock), [&] {
            log_info(what + ": another process is tracing this; waiting for it");
        }));
        truths = complete_truths(folder, request);
        if (std::optional<CachedTruth> there = served(truths, frame, request)) return std::move(*there);
        file = open_partial(with(stem, kPartial),
                            header_of(request, label, TileGroups(request.width, request.height).count()));
    } catch (const Error& e) {
        if (e.exit_code() != ExitCode::file_error) throw;
        log_warning(fmt::format("the truth is not kept: {}", e.what()));
        return uncached();
    } catch (const fs::filesystem_error& e) {
        log_warning(fmt::format("the truth is not kept: {}: {}", folder.string(), e.code().message()));
        return uncached();
    }
    const OpenTruth* base = base_of(truths, request);
    const std::size_t taken_over = file->groups();
    if (taken_over > 0) log_info(what + ": going on from where an earlier run ended");
    if (base != nullptr) log_info(what + ": refining a truth of fewer rays");

    FileStore store(*file, base != nullptr ? base->file.get() : nullptr, stem.string());
    CachedTruth result;
    result.made_for = request;
    if (taken_over > 0) {
        result.origin = TruthOrigin::resumed;
    } else if (base != nullptr) {
        result.origin = TruthOrigin::refined;
    }
    try {
        result.truth = reference.trace(frame, request.queries, request.settings, what, &store);
    } catch (const Error& e) {
        if (e.exit_code() == ExitCode::interrupted)
            log_info(what + ": what is traced is kept; the same command goes on from there");
        throw;
    }
    std::error_code ec;
    if (store.failed()) {
        fs::remove(with(stem, kPartial), ec);
        return result;
    }
    try {
        file->finish();
        fs::rename(with(stem, kPartial), with(stem, kComplete));
    } catch (const std::exception& e) {
        log_warning(fmt::format("the truth is not kept: {}", e.what()));
        return result;
    }
    // What this truth is at least as good as is not needed any more.
    for (const OpenTruth& truth : truths) {
        if (serves(request, truth.request)) fs::remove(truth.path, ec);
    }
    return result;
}

CachedTruth trace_truth(const fs::path& folder, const ReferenceScene& reference, const TruthRequest& request,
                        const TruthLabel& label, const std::string& what) {
    if (!folder.empty()) return TruthCache(folder).trace(reference, request, label, what);
    const CameraFrame frame(request.camera, request.width, request.height);
    return {reference.trace(frame, request.queries, request.settings, what), TruthOrigin::traced, request};
}

}  // namespace aoscore
