#include "store/truth/cache_file.h"

#include "core/error.h"
#include "core/hash.h"
#include "core/json_text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace aoscore {
namespace {

/// The header of a block, before its bytes.
struct BlockHead {
    std::uint32_t kind;
    std::uint32_t index;
    std::uint64_t size;
    std::array<char, 32> digest;  ///< the digest of the members above and the bytes
};

std::array<char, 32> digest_of(const BlockHead& head, std::string_view bytes) {
    const std::string hex = Digest().value(head.kind).value(head.index).text(bytes).hex();
    std::array<char, 32> digest;
    std::copy_n(hex.begin(), digest.size(), digest.begin());
    return digest;
}

/// Reads up to `size` bytes, as many as there are.
std::size_t read_at(int descriptor, void* to, std::size_t size, std::uint64_t offset) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t n =
            pread(descriptor, static_cast<char*>(to) + done, size - done, static_cast<off_t>(offset + done));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        done += static_cast<std::size_t>(n);
    }
    return done;
}

}  // namespace

CacheFile::CacheFile(const std::filesystem::path& path, Mode mode) : path_(path) {
    descriptor_ = open(path.c_str(), (mode == Mode::append ? O_RDWR : O_RDONLY) | O_CLOEXEC);
    if (descriptor_ < 0) throw file_error(std::strerror(errno), path.string());
    try {
        scan();
        if (!header_.is_object()) throw file_error("is no truth of this cache, or damaged", path.string());
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

CacheFile::CacheFile(const std::filesystem::path& path, const nlohmann::json& header)
    : path_(path), header_(header) {
    descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throw file_error(std::strerror(errno), path.string());
    try {
        write_block(Kind::header, 0, json_text(header));
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

CacheFile::~CacheFile() {
    close(descriptor_);
}

bool CacheFile::has(std::size_t group) const {
    const std::scoped_lock lock(mutex_);
    return groups_.contains(group);
}

std::size_t CacheFile::groups() const {
    const std::scoped_lock lock(mutex_);
    return groups_.size();
}

std::vector<std::size_t> CacheFile::numbers() const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::size_t> list;
    for (const auto& [number, place] : groups_) list.push_back(number);
    return list;
}

std::string CacheFile::read(std::size_t group) const {
    Place place{};
    {
        const std::scoped_lock lock(mutex_);
        place = groups_.at(group);
    }
    std::string bytes(place.size, '\0');
    if (read_at(descriptor_, bytes.data(), bytes.size(), place.offset) != bytes.size())
        throw file_error("cannot be read", path_.string());
    return bytes;
}

void CacheFile::append(std::size_t group, std::string_view bytes) {
    const std::scoped_lock lock(mutex_);
    const std::uint64_t begin = end_ + sizeof(BlockHead);
    write_block(Kind::group, static_cast<std::uint32_t>(group), bytes);
    groups_[group] = {begin, bytes.size()};
}

void CacheFile::finish() {
    const std::scoped_lock lock(mutex_);
    write_block(Kind::end, 0, {});
    finished_ = true;
    if (fsync(descriptor_) != 0) throw file_error(std::strerror(errno), path_.string());
}

void CacheFile::write_block(Kind kind, std::uint32_t index, std::string_view bytes) {
    BlockHead head{static_cast<std::uint32_t>(kind), index, bytes.size(), {}};
    head.digest = digest_of(head, bytes);
    std::string block(reinterpret_cast<const char*>(&head), sizeof head);
    block += bytes;
    std::size_t done = 0;
    while (done < block.size()) {
        const ssize_t n =
            pwrite(descriptor_, block.data() + done, block.size() - done, static_cast<off_t>(end_ + done));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) throw file_error(std::strerror(errno), path_.string());
        done += static_cast<std::size_t>(n);
    }
    end_ += block.size();
}

void CacheFile::scan() {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) throw file_error(std::strerror(errno), path_.string());
    if (!S_ISREG(status.st_mode)) throw file_error("is no file", path_.string());
    const auto total = static_cast<std::uint64_t>(status.st_size);
    std::uint64_t valid_bytes = 0;
    for (std::uint64_t at = 0; at + sizeof(BlockHead) <= total;) {
        BlockHead head{};
        if (read_at(descriptor_, &head, sizeof head, at) != sizeof head) break;
        if (head.size > total - at - sizeof head) break;
        std::string bytes(head.size, '\0');
        if (read_at(descriptor_, bytes.data(), bytes.size(), at + sizeof head) != bytes.size()) break;
        const std::uint64_t next = at + sizeof head + head.size;
        if (head.digest == digest_of(head, bytes)) {
            if (head.kind == static_cast<std::uint32_t>(Kind::header))
                header_ = nlohmann::json::parse(bytes, nullptr, false);
            if (head.kind == static_cast<std::uint32_t>(Kind::group))
                groups_[head.index] = {at + sizeof head, head.size};
            finished_ = head.kind == static_cast<std::uint32_t>(Kind::end);
            valid_bytes += next - at;
            end_ = next;
        }
        at = next;
    }
    damaged_bytes_ = total - valid_bytes;
}

}  // namespace aoscore
