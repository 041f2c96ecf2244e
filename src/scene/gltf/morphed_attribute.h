#pragma once

#include "scene/gltf/accessors.h"
#include "scene/gltf/attribute_type.h"

#include <glm/glm.hpp>

#include <string>
#include <utility>
#include <vector>

namespace tinygltf {
struct Primitive;
}

namespace aoscore::gltf {

/// An attribute, with the displacements of the primitive's morph targets added, each times its weight (glTF
/// 2.0, Khronos 2021, section 3.7.2.2).
class MorphedAttribute {
  public:
    /// `base` is the attribute as modelled. Targets of weight 0 are not read. Throws file_error for a target
    /// of another count or type.
    MorphedAttribute(Document& document, const tinygltf::Primitive& primitive, const std::string& name,
                     const Accessor& base, const std::vector<double>& weights, const std::string& place);

    std::size_t count() const { return base_.count(); }

    /// Element `i`, as Accessor::vector() returns it.
    template <int N>
    glm::vec<N, float> vector(std::size_t i) const {
        if (targets_.empty()) return base_.vector<N>(i);
        glm::vec<N, double> sum(base_.vector<N>(i));
        for (const auto& [weight, displacement] : targets_)
            sum += weight * glm::vec<N, double>(displacement.template vector<N>(i));
        return glm::vec<N, float>(sum);
    }

  private:
    Accessor base_;
    std::vector<std::pair<double, Accessor>> targets_;
};

}  // namespace aoscore::gltf
