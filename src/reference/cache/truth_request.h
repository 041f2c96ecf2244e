#pragma once

#include "reference/truth.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Raise this with every change that changes a bit of any truth: of points, rays, tracing, sums or estimates.
/// Truths of another version are not used.
inline constexpr int kIntegratorVersion = 4;

/// Everything that a truth depends on.
struct TruthRequest {
    std::string scene_digest;
    Camera camera;
    int width = 0, height = 0;
    std::vector<TruthQuery> queries;
    TruthSettings settings;
    TraceBuild build;

    /// What two truths must share to be made of the same rays; also integrator and Embree.
    nlohmann::json picture() const;
    /// What is read from these rays, and how many there are.
    nlohmann::json wanted() const;
    /// Digests of the two.
    std::string picture_key() const;
    std::string wanted_key() const;
};

/// The request whose wanted() a cached truth was made for. Throws json exceptions for another form.
TruthRequest request_from_json(const nlohmann::json& wanted, const TruthRequest& of_same_picture);

/// Whether a truth made for `have` is as good as one for `want` of the same picture, or better: it has all
/// queries and extras, and no pixel has fewer rays or may have a larger error.
bool serves(const TruthRequest& have, const TruthRequest& want);

/// Whether tracing `want` may go on from what was traced for `have`, of the same picture.
bool can_begin(const TruthRequest& have, const TruthRequest& want);

}  // namespace aoscore
