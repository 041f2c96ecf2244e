#include "core/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <new>

namespace aoscore {

struct Digest::State {
    XXH3_state_t* xxh = XXH3_createState();
    State() {
        if (xxh == nullptr || XXH3_128bits_reset(xxh) != XXH_OK) throw std::bad_alloc();
    }
    ~State() { XXH3_freeState(xxh); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

Digest::Digest() : state_(std::make_unique<State>()) {}
Digest::~Digest() = default;
Digest::Digest(Digest&&) noexcept = default;
Digest& Digest::operator=(Digest&&) noexcept = default;

Digest& Digest::bytes(const void* data, std::size_t size) {
    if (size > 0) XXH3_128bits_update(state_->xxh, data, size);
    return *this;
}

Digest& Digest::text(std::string_view value) {
    this->value(value.size());
    return bytes(value.data(), value.size());
}

std::string Digest::hex() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace aoscore
