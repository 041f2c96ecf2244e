#include "jobs/contest/truth_image.h"

#include "core/error.h"

#include <algorithm>

namespace aoscore {

std::size_t query_index(const Truth& truth, const TruthQuery& query) {
    const auto found = std::ranges::find(truth.queries, query);
    if (found == truth.queries.end()) throw internal_error("the truth was not traced for a query", "truth");
    return static_cast<std::size_t>(found - truth.queries.begin());
}

const ImageF& true_visibility(const Truth& truth, const TruthQuery& query) {
    return truth.visibility[query_index(truth, query)];
}

ImageF one_layer_visibility(const Truth& truth) {
    if (truth.one_layer_bound.empty())
        throw internal_error("the truth was traced without its one-layer bound", "truth");
    ImageF visibility = truth.one_layer_bound;
    for (float& v : visibility.pixels) v = 1 - v;
    return visibility;
}

}  // namespace aoscore
