#pragma once

#include "reference/truth.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Everything that a truth depends on.
struct TruthRequest {
    std::string scene_digest;
    Camera camera;
    int width = 0, height = 0;
    std::vector<TruthQuery> queries;
    TruthSettings settings;
    TraceBuild build;

    /// The properties that truths share when they are made of the same rays; integrator and Embree are among
    /// them.
    nlohmann::json picture() const;
    /// The quantities that are computed from these rays, and the number of rays.
    nlohmann::json wanted() const;
    /// The digests of picture() and wanted().
    std::string picture_key() const;
    std::string wanted_key() const;
};

/// The request for which a cached truth with this wanted() was made. Throws json exceptions for another form.
TruthRequest request_from_json(const nlohmann::json& wanted, const TruthRequest& of_same_picture);

/// Whether a truth made for `have` is as good as one for `want` of the same picture, or better: it has all
/// queries and extras, and no pixel has fewer rays or may have a larger error.
bool serves(const TruthRequest& have, const TruthRequest& want);

/// Whether tracing `want` may go on from the rays of `have`, a truth of the same picture.
bool can_begin(const TruthRequest& have, const TruthRequest& want);

}  // namespace aoscore
