#pragma once

#include "scene/gltf/pose.h"
#include "scene/gltf/primitive_data.h"

#include <glm/glm.hpp>

#include <utility>
#include <vector>

namespace aoscore::gltf {

/// Moves each vertex of a primitive with the joints of a skin, by the weighted mean of their matrices.
class SkinnedVertices {
  public:
    /// Reads JOINTS_n and WEIGHTS_n of every set. Throws file_error for sets of another count than
    /// `vertices`, and where there is none.
    SkinnedVertices(Document& document, PrimitiveData& data, const JointMatrices& joints,
                    std::size_t vertices);

    /// The matrix that takes vertex `i`, as modelled, to its place less the joints' anchor. Weights are
    /// divided by their sum; a vertex whose weights are all 0 follows its first joint. Throws file_error for
    /// a joint that the skin does not have (unless its weight is 0).
    glm::dmat4 matrix(std::size_t i) const;

  private:
    const glm::dmat4& joint(std::size_t i, const Accessor& accessor, float number) const;

    Document& document_;
    const JointMatrices& joints_;
    std::vector<std::pair<Accessor, Accessor>> sets_;  // joints, weights
};

}  // namespace aoscore::gltf
