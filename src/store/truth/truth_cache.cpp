#include "store/truth/truth_cache.h"

#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "reference/halved_truth.h"
#include "reference/integrator/tile.h"
#include "reference/sampling/sample_plan.h"
#include "store/truth/cache_file.h"
#include "store/truth/entry_lock.h"
#include "store/truth/help_tracing.h"
#include "store/truth/tile_codec.h"
#include "store/truth/tracing_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kComplete = ".truth";
constexpr const char* kPartial = ".partial";
constexpr const char* kSearch = ".search";
constexpr const char* kLock = ".lock";
constexpr const char* kSalvage = ".salvage";

fs::path with(const fs::path& stem, const char* extension) {
    return fs::path(stem) += extension;
}

/// A cache file as a store of tiles. It writes nothing to a file that is open for reading only.
class FileStore : public TileStore {
  public:
    FileStore(CacheFile& file, const CacheFile* base, std::string where)
        : file_(file), base_(base), where_(std::move(where)) {}

    bool has(std::size_t group) const override { return file_.has(group); }
    GroupState load(std::size_t group) const override { return decode(file_.read(group), where_); }
    GroupState begun(std::size_t group) const override {
        return base_ != nullptr && base_->has(group) ? decode(base_->read(group), where_) : GroupState{};
    }
    void keep(std::size_t group, const GroupState& state) override { take(group, state); }
    bool failed() const { return failed_; }

  protected:
    void take(std::size_t group, const GroupState& state) const {
        if (failed_) return;
        try {
            file_.append(group, encode(state));
        } catch (const Error& e) {
            if (e.exit_code() != ExitCode::file_error) throw;
            if (!failed_.exchange(true)) log_warning(fmt::format("the truth is not kept: {}", e.what()));
        }
    }

  private:
    CacheFile& file_;
    const CacheFile* base_;
    std::string where_;
    mutable std::atomic<bool> failed_{false};
};

/// A store that takes over what processes that wait for the truth have traced of it.
class HelpedStore final : public FileStore {
  public:
    /// `search` is where the search for a mean error keeps what it traces; null where there is none.
    HelpedStore(CacheFile& file, const CacheFile* base, const std::string& where, const TracingHelp& help,
                CacheFile* search)
        : FileStore(file, base, where), help_(help), begun_(help.chunks()) {
        if (search != nullptr) search_.emplace(*search, nullptr, where);
    }

    bool has(std::size_t group) const override { return FileStore::has(group) || take_over(group); }
    bool begun_elsewhere(std::size_t group) override {
        const std::scoped_lock lock(mutex_);
        std::optional<bool>& elsewhere = begun_[help_.chunk_of(group)];
        if (!elsewhere) elsewhere = !help_.claim(help_.chunk_of(group));
        return *elsewhere && !FileStore::has(group);
    }
    TileStore* of_search() override { return search_ ? &*search_ : nullptr; }

  private:
    bool take_over(std::size_t group) const {
        const std::scoped_lock lock(mutex_);
        if (FileStore::has(group)) return true;
        const std::size_t chunk = help_.chunk_of(group);
        const auto states = help_.published(chunk);
        if (!states) return false;
        const std::vector<std::size_t> numbers = help_.groups_of(chunk);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (!FileStore::has(numbers[i])) take(numbers[i], (*states)[i]);
        }
        return FileStore::has(group);
    }

    const TracingHelp& help_;
    std::optional<FileStore> search_;
    mutable std::mutex mutex_;
    std::vector<std::optional<bool>> begun_;  ///< by chunk: whether elsewhere; empty where nobody asked
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

/// Keeps the undamaged groups of a damaged truth as the beginning of a new one.
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
            // Another process may have replaced the file by a better one meanwhile.
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
        // The exact truth is preferred, so that the same command gives the same picture.
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

/// The truth with most rays from which tracing can go on to the wanted one.
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

/// A file of the same path that holds the undamaged groups of a damaged file.
std::unique_ptr<CacheFile> salvaged(const CacheFile& damaged, const fs::path& path) {
    const fs::path temporary = fs::path(path).replace_extension(kSalvage);
    auto file = std::make_unique<CacheFile>(temporary, damaged.header());
    for (const std::size_t g : damaged.numbers()) file->append(g, damaged.read(g));
    fs::rename(temporary, path);
    return file;
}

/// Opens the file that an interrupted run left, or a new one.
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
        case TruthOrigin::given:
            return "given";
    }
    return "";
}

std::string scene_name(const Scene& scene) {
    return scene.file.empty() ? scene.id : fs::absolute(scene.file).string();
}

namespace {

/// One truth that is taken from a cache, or traced into it.
class CachedTracing {
  public:
    CachedTracing(const fs::path& cache, const ReferenceScene& reference, const TruthRequest& request,
                  const TruthLabel& label, const std::string& what)
        : reference_(reference),
          request_(request),
          label_(label),
          what_(what),
          frame_(request.camera, request.width, request.height),
          folder_(cache / request.picture_key()),
          stem_(folder_ / request.wanted_key()),
          help_(stem_, TileGroups(request.width, request.height).count()) {}

    CachedTruth run() {
        if (std::optional<CachedTruth> there = served(complete_truths(folder_, request_), frame_, request_)) {
            log_info(what_ + ": from the cache");
            return std::move(*there);
        }
        try {
            if (std::optional<CachedTruth> there = open()) return std::move(*there);
        } catch (const Error& e) {
            if (e.exit_code() != ExitCode::file_error) throw;
            return uncached(e.what());
        } catch (const fs::filesystem_error& e) {
            return uncached(fmt::format("{}: {}", folder_.string(), e.code().message()));
        }
        return traced();
    }

  private:
    /// Takes the lock, and opens the file for tiles; or returns the truth, where another process has traced
    /// it while this one helped and waited.
    std::optional<CachedTruth> open() {
        fs::create_directories(folder_);
        const bool helped = !try_lock() && help();
        if (!lock_) {
            lock_.emplace(EntryLock::acquire(with(stem_, kLock), [&] {
                log_info(what_ + ": another process is tracing this; waiting for it");
            }));
        }
        truths_ = complete_truths(folder_, request_);
        if (std::optional<CachedTruth> there = served(truths_, frame_, request_)) {
            if (helped) help_.remove();  // what came too late
            return there;
        }
        const std::size_t groups = TileGroups(request_.width, request_.height).count();
        const json header = header_of(request_, label_, groups);
        file_ = open_partial(with(stem_, kPartial), header);
        if (request_.settings.mean_error > 0) search_ = open_partial(with(stem_, kSearch), header);
        begin_chunks();
        return std::nullopt;
    }

    bool try_lock() {
        if (std::optional<EntryLock> lock = EntryLock::try_acquire(with(stem_, kLock)))
            lock_.emplace(std::move(*lock));
        return lock_.has_value();
    }

    /// Traces what the process that has the lock has not begun, until there is no more of it or the lock is
    /// free, which this process then has. False where it was of no use.
    bool help() {
        log_info(what_ + ": another process is tracing this; helping it");
        const std::vector<OpenTruth> truths = complete_truths(folder_, request_);
        const OpenTruth* base = base_of(truths, request_);
        try {
            help_tracing(help_, reference_, request_, base != nullptr ? base->file.get() : nullptr,
                         [&] { return try_lock(); });
        } catch (const Error& e) {
            if (e.exit_code() != ExitCode::file_error) throw;
            return false;
        }
        return true;
    }

    /// Lets helpers begin all chunks but those that are there.
    void begin_chunks() const {
        help_.forget_claims();
        for (std::size_t chunk = 0; chunk < help_.chunks(); ++chunk) {
            const auto there = [&](std::size_t group) { return file_->has(group); };
            if (std::ranges::all_of(help_.groups_of(chunk), there)) help_.claim(chunk);
        }
    }

    CachedTruth uncached(const std::string& why) const {
        log_warning(fmt::format("the truth is not kept: {}", why));
        return trace_truth({}, reference_, request_, label_, what_);
    }

    CachedTruth traced() {
        const OpenTruth* base = base_of(truths_, request_);
        CachedTruth result;
        result.made_for = request_;
        if (base != nullptr) {
            result.origin = TruthOrigin::refined;
            log_info(what_ + ": refining a truth of fewer rays");
        }
        if (file_->groups() > 0 || (search_ && search_->groups() > 0)) {
            result.origin = TruthOrigin::resumed;
            log_info(what_ + ": going on from where an earlier run ended");
        }
        HelpedStore store(*file_, base != nullptr ? base->file.get() : nullptr, stem_.string(), help_,
                          search_.get());
        try {
            result.truth = reference_.trace(frame_, request_.queries, request_.settings, what_, &store);
        } catch (const Error& e) {
            if (e.exit_code() == ExitCode::interrupted)
                log_info(what_ + ": what is traced is kept; the same command goes on from there");
            throw;
        }
        keep(store);
        return result;
    }

    /// Makes the traced file a complete truth of the cache, and removes those that it replaces.
    void keep(const FileStore& store) {
        std::error_code ec;
        help_.remove();
        fs::remove(with(stem_, kSearch), ec);
        if (store.failed()) {
            fs::remove(with(stem_, kPartial), ec);
            return;
        }
        try {
            file_->finish();
            fs::rename(with(stem_, kPartial), with(stem_, kComplete));
        } catch (const std::exception& e) {
            log_warning(fmt::format("the truth is not kept: {}", e.what()));
            return;
        }
        for (const OpenTruth& truth : truths_) {
            if (serves(request_, truth.request)) fs::remove(truth.path, ec);
        }
    }

    const ReferenceScene& reference_;
    const TruthRequest& request_;
    const TruthLabel& label_;
    const std::string& what_;
    const CameraFrame frame_;
    const fs::path folder_, stem_;
    const TracingHelp help_;
    std::optional<EntryLock> lock_;
    std::unique_ptr<CacheFile> file_, search_;
    std::vector<OpenTruth> truths_;
};

}  // namespace

CachedTruth TruthCache::trace(const ReferenceScene& reference, const TruthRequest& request,
                              const TruthLabel& label, const std::string& what) const {
    check_truth_request(request.queries, request.settings);
    return CachedTracing(folder_, reference, request, label, what).run();
}

namespace {

TruthRequest half_of(const TruthRequest& request, std::size_t half) {
    TruthRequest one = request;
    one.settings = settings_of_half(request.settings, half);
    return one;
}

/// One half of `request`, traced with `samples` rays a pixel.
CachedTruth trace_half(const fs::path& folder, const ReferenceScene& reference, const TruthRequest& request,
                       std::size_t half, int samples, const TruthLabel& label, const std::string& what) {
    TruthRequest one = half_of(request, half);
    one.settings.samples = samples;
    return trace_truth(folder, reference, one, label, fmt::format("{}, half {} of 2", what, half + 1));
}

/// The origin of the mean of two halves, which was traced where one of them was.
TruthOrigin origin_of(TruthOrigin first, TruthOrigin second) {
    return std::min(first, second);
}

CachedTruth trace_halves(const fs::path& folder, const ReferenceScene& reference, const TruthRequest& request,
                         const TruthLabel& label, const std::string& what) {
    check_truth_request(request.queries, request.settings);
    std::array<CachedTruth, 2> halves;
    int samples = request.settings.samples / 2;
    // Where an earlier run was stopped, the cache may have more rays of one half: the other gets as many.
    for (bool alike = false; !alike;) {
        for (std::size_t half = 0; half < 2; ++half) {
            if (halves[half].made_for.settings.samples == samples && !halves[half].truth.visibility.empty())
                continue;
            halves[half] = trace_half(folder, reference, request, half, samples, label, what);
            samples = std::max(samples, halves[half].made_for.settings.samples);
        }
        alike = halves[0].made_for.settings.samples == halves[1].made_for.settings.samples;
    }
    CachedTruth result;
    result.origin = origin_of(halves[0].origin, halves[1].origin);
    result.made_for = halves[0].made_for;
    result.made_for.settings.halves = true;
    result.made_for.settings.samples = 2 * samples;
    result.made_for.settings.seed = request.settings.seed;
    result.truth = mean_of_halves(std::move(halves[0].truth), std::move(halves[1].truth));
    return result;
}

}  // namespace

void forget_truth(const fs::path& folder, const TruthRequest& request) {
    if (folder.empty()) return;
    if (request.settings.halves) {
        for (std::size_t half = 0; half < 2; ++half) forget_truth(folder, half_of(request, half));
        return;
    }
    const fs::path picture = folder / request.picture_key();
    std::error_code ec;
    fs::remove(with(picture / request.wanted_key(), kComplete), ec);
    fs::remove(picture, ec);  // succeeds only where it is empty
}

CachedTruth trace_truth(const fs::path& folder, const ReferenceScene& reference, const TruthRequest& request,
                        const TruthLabel& label, const std::string& what) {
    if (request.settings.halves) return trace_halves(folder, reference, request, label, what);
    if (!folder.empty()) return TruthCache(folder).trace(reference, request, label, what);
    const CameraFrame frame(request.camera, request.width, request.height);
    return {reference.trace(frame, request.queries, request.settings, what), TruthOrigin::traced, request};
}

}  // namespace aoscore
