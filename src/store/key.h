#pragma once

#include "core/hash.h"
#include "scene/camera.h"

#include <compare>
#include <span>
#include <string>
#include <string_view>

namespace aoscore {

/// Names an artifact by all that decides its content: artifacts of one key are the same.
struct Key {
    std::string hex;  ///< 32 lower-case hexadecimal digits

    auto operator<=>(const Key&) const = default;
};

/// Builds the key of an artifact. It begins with the artifact's kind and the digest of the code that makes
/// it; then everything that decides its content is added, in a fixed order.
class KeyBuilder {
  public:
    /// `kind` is the artifact's, made by the code of that name in code_digest(), or by `code` where several
    /// kinds share one.
    explicit KeyBuilder(std::string_view kind) : KeyBuilder(kind, kind) {}
    KeyBuilder(std::string_view kind, std::string_view code);

    /// Adds an artifact that this one is made of.
    KeyBuilder& input(const Key& key) { return text(key.hex); }
    KeyBuilder& text(std::string_view value);
    KeyBuilder& camera(const Camera& camera);

    /// Adds a number, or a struct without padding.
    template <class T>
    KeyBuilder& value(const T& v) {
        digest_.value(v);
        return *this;
    }
    template <class T>
    KeyBuilder& array(std::span<const T> values) {
        digest_.array(values);
        return *this;
    }

    Key key() const { return {digest_.hex()}; }

  private:
    Digest digest_;
};

}  // namespace aoscore
