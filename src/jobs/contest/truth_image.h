#pragma once

#include "reference/truth.h"

#include <cstddef>

namespace aoscore {

/// The index of the query in the truth. Throws internal_error where it was not traced for it.
std::size_t query_index(const Truth& truth, const TruthQuery& query);

/// The truth's visibility for the query.
const ImageF& true_visibility(const Truth& truth, const TruthQuery& query);

/// The least visibility of a method that knows one depth layer: it finds all occlusion in that layer.
ImageF one_layer_visibility(const Truth& truth);

}  // namespace aoscore
