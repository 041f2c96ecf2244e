#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace aoscore {

/// Builds the content digest (XXH3, 128 bits) that keys caches and names scenes. Feed everything that changes
/// the result, in a fixed order.
class Digest {
  public:
    Digest();
    ~Digest();
    Digest(Digest&&) noexcept;
    Digest& operator=(Digest&&) noexcept;

    Digest& bytes(const void* data, std::size_t size);
    /// Adds a text with its length, so that "ab","c" differs from "a","bc".
    Digest& text(std::string_view value);

    /// Adds a number, or a struct without padding.
    template <class T>
    requires std::is_trivially_copyable_v<T> Digest& value(const T& v) { return bytes(&v, sizeof v); }
    /// Adds an array with its length.
    template <class T>
    requires std::is_trivially_copyable_v<T> Digest& array(std::span<const T> values) {
        value(values.size());
        return bytes(values.data(), values.size_bytes());
    }

    /// The digest in 32 lower-case hexadecimal digits.
    std::string hex() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aoscore
