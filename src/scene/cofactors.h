#pragma once

#include <glm/glm.hpp>

namespace aoscore {

/// The matrix that takes normals along where `m` takes points, up to length and sign; unlike the transposed
/// inverse it exists for every matrix.
inline glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

}  // namespace aoscore
