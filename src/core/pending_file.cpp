#include "core/pending_file.h"

#include "core/error.h"
#include "core/temporary_folder.h"
#include "core/write_through.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// The path that symbolic links lead to, whether a file exists there or not.
fs::path followed(const fs::path& path) {
    constexpr int kMostLinks = 40;  // as many as Linux follows
    fs::path target = path;
    std::error_code ec;
    for (int i = 0; i < kMostLinks; ++i) {
        if (!fs::is_symlink(fs::symlink_status(target, ec))) return target;
        target = target.parent_path() / fs::read_symlink(target, ec);  // an absolute link replaces all
    }
    throw file_error("is a circle of links", path.string(), "a file to write");
}

/// A name that nobody else has.
fs::path temporary_for(const fs::path& target, const fs::path& folder) {
    static std::atomic<int> counter{0};
    // The extension stays last: image libraries choose the format by it.
    return folder / fmt::format(".{}.{}-{}.tmp{}", target.stem().string(), getpid(), counter++,
                                target.extension().string());
}

}  // namespace

PendingFile::PendingFile(const fs::path& path) : path_(path), target_(path) {
    std::error_code ec;
    const fs::file_status status = fs::status(path, ec);
    if (fs::is_directory(status)) throw file_error("is a folder", path.string(), "a file to write");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        if (access(path.c_str(), W_OK) != 0)
            throw file_error("cannot be written: " + std::generic_category().message(errno), path.string());
        elsewhere_ = std::make_unique<TemporaryFolder>();
        temporary_ = temporary_for(path, elsewhere_->path());
    } else {
        target_ = followed(path);
        temporary_ = temporary_for(target_, target_.parent_path());
    }
}

PendingFile::PendingFile(PendingFile&&) noexcept = default;

PendingFile::~PendingFile() {
    std::error_code ec;
    fs::remove(temporary_, ec);
}

void PendingFile::publish() {
    if (elsewhere_) {
        write_through(temporary_, target_);
        return;
    }
    std::error_code ec;
    fs::rename(temporary_, target_, ec);
    if (ec) throw file_error("cannot be written: " + ec.message(), path_.string());
}

void move_to_place(const fs::path& from, const fs::path& to) {
    PendingFile file(to);
    std::error_code ec;
    fs::rename(from, file.temporary(), ec);
    if (ec) {
        ec.clear();
        fs::copy_file(from, file.temporary(), ec);
        if (!ec) fs::remove(from, ec);
    }
    if (ec) throw file_error("cannot be written: " + ec.message(), to.string());
    file.publish();
}

}  // namespace aoscore
