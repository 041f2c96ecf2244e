#include "core/write_through.h"

#include "core/error.h"
#include "core/interrupt.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <system_error>
#include <thread>

namespace aoscore {
namespace {

constexpr int kPoll_ms = 50;

[[noreturn]] void fail(const std::filesystem::path& to) {
    throw file_error("cannot be written: " + std::generic_category().message(errno), to.string());
}

/// A device or pipe that is open for writing; neither opening nor writing it waits without end.
class Sink {
  public:
    explicit Sink(const std::filesystem::path& path)
        : path_(path), old_handler_(std::signal(SIGPIPE, SIG_IGN)) {
        // A pipe that nobody reads yet cannot be opened.
        while ((descriptor_ = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) < 0 &&
               errno == ENXIO) {
            throw_if_interrupted();
            std::this_thread::sleep_for(std::chrono::milliseconds(kPoll_ms));
        }
        if (descriptor_ < 0) fail(path);
    }
    ~Sink() {
        close(descriptor_);
        std::signal(SIGPIPE, old_handler_);
    }
    Sink(const Sink&) = delete;
    Sink& operator=(const Sink&) = delete;

    void write_all(const char* bytes, std::size_t size) {
        while (size > 0) {
            const ssize_t written = write(descriptor_, bytes, size);
            if (written > 0) {
                bytes += written;
                size -= static_cast<std::size_t>(written);
            } else if (errno == EAGAIN || errno == EINTR) {
                throw_if_interrupted();
                pollfd ready{descriptor_, POLLOUT, 0};
                poll(&ready, 1, kPoll_ms);
            } else {
                fail(path_);
            }
        }
    }

  private:
    const std::filesystem::path& path_;
    void (*old_handler_)(int);
    int descriptor_ = -1;
};

}  // namespace

void write_through(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::ifstream source(from, std::ios::binary);
    if (!source) throw file_error("cannot be read", from.string());
    Sink sink(to);
    std::array<char, 65536> block{};
    while (source.read(block.data(), block.size()) || source.gcount() > 0)
        sink.write_all(block.data(), static_cast<std::size_t>(source.gcount()));
}

}  // namespace aoscore
