#pragma once

#include "reference/truth.h"

#include <cstddef>

namespace aoscore {

/// Where the truth has the query. Throws internal_error where it was not traced for it.
std::size_t query_index(const Truth& truth, const TruthQuery& query);

/// The truth's visibility of the query.
const ImageF& true_visibility(const Truth& truth, const TruthQuery& query);

/// The visibility that a method would show at least which finds all occlusion that is in one depth layer.
ImageF one_layer_visibility(const Truth& truth);

}  // namespace aoscore
