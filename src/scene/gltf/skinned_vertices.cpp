#include "scene/gltf/skinned_vertices.h"

#include "core/error.h"

#include <fmt/format.h>

namespace aoscore::gltf {

SkinnedVertices::SkinnedVertices(Document& document, PrimitiveData& data, const JointMatrices& joints,
                                 std::size_t vertices)
    : document_(document), joints_(joints) {
    for (int set = 0;; ++set) {
        const std::string joints_name = fmt::format("JOINTS_{}", set),
                          weights_name = fmt::format("WEIGHTS_{}", set);
        auto numbers = data.attribute(joints_name, {.components = {4}, .floats = false, .joints = true});
        auto weights = data.attribute(weights_name, {.components = {4}, .unsigned_integers = true});
        if (!numbers || !weights) break;
        for (const Accessor* accessor : {&*numbers, &*weights}) {
            if (accessor->count() == vertices) continue;
            throw file_error(fmt::format("{} has {} elements, POSITION has {}", accessor->name(),
                                         accessor->count(), vertices),
                             data.place() + ".attributes");
        }
        sets_.emplace_back(std::move(*numbers), std::move(*weights));
    }
    if (sets_.empty())
        throw file_error("lacks JOINTS_0 or WEIGHTS_0, though its node has a skin", data.place());
}

const glm::dmat4& SkinnedVertices::joint(std::size_t i, const Accessor& accessor, float number) const {
    const auto index = static_cast<std::size_t>(number);
    if (index >= joints_.anchored_from_mesh.size()) {
        throw file_error(
            fmt::format("vertex {} follows joint {} of {}", i, index, joints_.anchored_from_mesh.size()),
            fmt::format("{}: {}", document_.where, accessor.name()));
    }
    return joints_.anchored_from_mesh[index];
}

glm::dmat4 SkinnedVertices::matrix(std::size_t i) const {
    glm::dmat4 sum(0.0);
    double total = 0;
    for (const auto& [numbers, weights] : sets_) {
        const glm::vec4 number = numbers.vector<4>(i), weight = weights.vector<4>(i);
        for (int k = 0; k < 4; ++k) {
            if (weight[k] == 0) continue;
            sum += static_cast<double>(weight[k]) * joint(i, numbers, number[k]);
            total += static_cast<double>(weight[k]);
        }
    }
    if (total > 0) return sum / total;
    document_.warn("vertices of skinned meshes have no weights: they follow their first joint");
    const Accessor& first = sets_.front().first;
    return joint(i, first, first.vector<4>(i).x);
}

}  // namespace aoscore::gltf
