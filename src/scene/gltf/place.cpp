#include "scene/gltf/place.h"

#include <algorithm>

namespace aoscore::gltf {

std::string Place::text() const {
    if (parent_ == nullptr) return printable(key_);
    std::string text = parent_->text();
    if (key_.empty()) return text + "[" + std::to_string(index_) + "]";
    return text + (parent_->parent_ == nullptr ? ": " : ".") + std::string(key_);
}

std::string printable(std::string_view name) {
    constexpr std::size_t kMaxBytes = 64;
    // A path is cut in front, where it says least.
    const bool is_long = name.size() > kMaxBytes && name.find('/') == std::string_view::npos;
    std::string text(is_long ? name.substr(0, kMaxBytes) : name);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, '?');
    return is_long ? text + "..." : text;
}

}  // namespace aoscore::gltf
