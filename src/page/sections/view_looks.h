#pragma once

#include "page/section.h"

namespace aoscore {

/// The model of every view on the first screen: its sentences, its chart of cost against error, and four
/// pictures that lead to the stage: truth, the closest method's output, its signed error, its worst region.
nlohmann::json view_looks(const PageSource& source);

}  // namespace aoscore
