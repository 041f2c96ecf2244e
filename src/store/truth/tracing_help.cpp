#include "store/truth/tracing_help.h"

#include "core/error.h"
#include "core/log.h"
#include "store/truth/cache_file.h"
#include "store/truth/tile_codec.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr const char* kClaim = ".claim";
constexpr const char* kHelp = ".help";

/// Few enough for a folder of a network file system, and enough to share a truth among dozens of processes.
constexpr std::size_t kMostChunks = 64;

/// A chunk has groups for the threads of a process.
constexpr std::size_t kGroupsAChunk = 8;

}  // namespace

TracingHelp::TracingHelp(fs::path stem, std::size_t groups)
    : stem_(std::move(stem)),
      groups_(groups),
      groups_a_chunk_(std::max(kGroupsAChunk, (groups + kMostChunks - 1) / kMostChunks)) {
    chunks_ = (groups_ + groups_a_chunk_ - 1) / groups_a_chunk_;
}

fs::path TracingHelp::file(std::size_t chunk, const char* ending) const {
    return fs::path(stem_) += fmt::format(".{}{}", chunk, ending);
}

std::vector<std::size_t> TracingHelp::groups_of(std::size_t chunk) const {
    std::vector<std::size_t> groups;
    const std::size_t first = chunk * groups_a_chunk_;
    for (std::size_t g = first; g < std::min(groups_, first + groups_a_chunk_); ++g) groups.push_back(g);
    return groups;
}

bool TracingHelp::claim(std::size_t chunk) const {
    const int descriptor = open(file(chunk, kClaim).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (descriptor < 0) return errno != EEXIST;
    close(descriptor);
    return true;
}

void TracingHelp::publish(std::size_t chunk, const std::vector<GroupState>& groups) const {
    const fs::path path = file(chunk, kHelp);
    const fs::path temporary = fs::path(path) += fmt::format(".{}.tmp", getpid());
    {
        CacheFile written(temporary, {{"chunk", chunk}});
        for (std::size_t i = 0; i < groups.size(); ++i) written.append(i, encode(groups[i]));
        written.finish();
    }
    std::error_code failed;
    fs::rename(temporary, path, failed);
    if (failed) throw file_error("cannot be written: " + failed.message(), path.string());
}

std::optional<std::vector<GroupState>> TracingHelp::published(std::size_t chunk) const {
    const fs::path path = file(chunk, kHelp);
    std::error_code ec;
    if (!fs::exists(path, ec)) return std::nullopt;
    try {
        const CacheFile read(path, CacheFile::Mode::read);
        const std::vector<std::size_t> groups = groups_of(chunk);
        if (!read.finished() || read.damaged_bytes() > 0 || read.groups() != groups.size())
            throw file_error("is damaged", path.string());
        std::vector<GroupState> states;
        for (std::size_t i = 0; i < groups.size(); ++i) states.push_back(decode(read.read(i), path.string()));
        return states;
    } catch (const std::exception& e) {
        log_warning(fmt::format("{}; these tiles are traced here", e.what()));
        fs::remove(path, ec);
        return std::nullopt;
    }
}

void TracingHelp::forget_claims() const {
    std::error_code ec;
    for (std::size_t chunk = 0; chunk < chunks_; ++chunk) fs::remove(file(chunk, kClaim), ec);
}

void TracingHelp::remove() const {
    std::error_code ec;
    for (std::size_t chunk = 0; chunk < chunks_; ++chunk) fs::remove(file(chunk, kHelp), ec);
    forget_claims();
}

bool is_tracing_help(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.ends_with(kClaim) || name.ends_with(kHelp) ||
           (name.ends_with(".tmp") && name.find(kHelp) != std::string::npos);
}

}  // namespace aoscore
