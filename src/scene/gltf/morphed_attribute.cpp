#include "scene/gltf/morphed_attribute.h"

#include "core/error.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>

namespace aoscore::gltf {

MorphedAttribute::MorphedAttribute(Document& document, const tinygltf::Primitive& primitive,
                                   const std::string& name, const Accessor& base,
                                   const std::vector<double>& weights, const std::string& place)
    : base_(base) {
    const AttributeType type{.components = {base.components()},
                             .unsigned_integers = true,
                             .signed_normalized = true,
                             .quantized = true};
    for (std::size_t i = 0; i < std::min(weights.size(), primitive.targets.size()); ++i) {
        const auto found = primitive.targets[i].find(name);
        if (weights[i] == 0 || found == primitive.targets[i].end()) continue;
        Accessor target(document, found->second);
        const std::string target_place = fmt::format("{}.targets[{}].{}", place, i, name);
        check_type(document, target, type, target_place);
        if (target.count() != base.count()) {
            throw file_error(fmt::format("{} has {} elements, the attribute has {}", target.name(),
                                         target.count(), base.count()),
                             target_place);
        }
        targets_.emplace_back(weights[i], std::move(target));
    }
}

}  // namespace aoscore::gltf
