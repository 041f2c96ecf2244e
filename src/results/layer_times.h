#pragma once

#include "results/results.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aoscore {

/// Whether the cell's method reads several layers of depth. Results before schema 10 tell it by their times
/// alone.
inline bool reads_layers(const CellRecord& cell) {
    return cell.layer_bytes.has_value() || !cell.layers_processor.runs_ms.empty();
}

/// The runs of the AO pass as processor time, each without the part that drew its depth layers.
inline std::vector<double> runs_without_layers_ms(const CellRecord& cell) {
    std::vector<double> runs_ms = cell.ao.processor_runs_ms;
    const std::vector<double>& layers_ms = cell.layers_processor.runs_ms;
    for (std::size_t i = 0; i < std::min(runs_ms.size(), layers_ms.size()); ++i) runs_ms[i] -= layers_ms[i];
    return runs_ms;
}

}  // namespace aoscore
