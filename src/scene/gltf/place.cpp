#include "scene/gltf/place.h"

#include "core/printable.h"

namespace aoscore::gltf {

std::string Place::text() const {
    if (parent_ == nullptr) return printable(key_);
    std::string text = parent_->text();
    if (key_.empty()) return text + "[" + std::to_string(index_) + "]";
    return text + (parent_->parent_ == nullptr ? ": " : ".") + std::string(key_);
}

std::string printable(std::string_view name) {
    constexpr std::size_t kMaxBytes = 64;
    // A path is cut at its front, which says least.
    const bool is_long = name.size() > kMaxBytes && name.find('/') == std::string_view::npos;
    const std::string text = aoscore::printable(is_long ? name.substr(0, kMaxBytes) : name);
    return is_long ? text + "..." : text;
}

}  // namespace aoscore::gltf
