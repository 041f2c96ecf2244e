#include "core/staged_folder.h"

#include "core/error.h"
#include "core/pending_file.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

namespace fs = std::filesystem;

namespace {

const std::string kPrefix = ".incomplete-";

bool alive(long pid) {
    return kill(static_cast<pid_t>(pid), 0) == 0 || errno != ESRCH;
}

void remove_orphans(const fs::path& target) {
    std::error_code ec;
    std::vector<fs::path> orphans;
    for (const auto& entry : fs::directory_iterator(target, ec)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(kPrefix)) continue;
        const long pid = std::atol(name.c_str() + kPrefix.size());
        if (pid > 0 && !alive(pid)) orphans.push_back(entry.path());
    }
    for (const fs::path& orphan : orphans) fs::remove_all(orphan, ec);
}

}  // namespace

StagedFolder::StagedFolder(fs::path target) : target_(std::move(target)), made_target_(false) {
    std::error_code ec;
    made_target_ = !fs::exists(target_, ec);
    remove_orphans(target_);
    staging_ = target_ / (kPrefix + std::to_string(getpid()));
    fs::create_directories(staging_, ec);
    if (ec) throw file_error("folder cannot be made: " + ec.message(), target_.string());
}

StagedFolder::~StagedFolder() {
    std::error_code ec;
    fs::remove_all(staging_, ec);
    if (made_target_) fs::remove(target_, ec);  // removes the folder only while it is empty
}

void StagedFolder::publish() {
    try {
        for (const auto& entry : fs::recursive_directory_iterator(staging_)) {
            const fs::path place = target_ / fs::relative(entry.path(), staging_);
            if (entry.is_directory()) {
                fs::create_directories(place);
            } else {
                move_to_place(entry.path(), place);
            }
        }
    } catch (const fs::filesystem_error& e) {
        throw file_error("results cannot be put in place: " + e.code().message(), target_.string());
    }
}

}  // namespace aoscore
