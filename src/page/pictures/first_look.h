#pragma once

#include "core/image.h"
#include "metrics/analysis/regions.h"
#include "results/results.h"

#include <cstddef>
#include <optional>
#include <string>

namespace aoscore {

/// The range of signed error, up and down, that the first screen's pictures show.
inline constexpr double kFirstLookRange = 0.5;

/// A view at a glance: PNGs that a browser shows without a script.
struct FirstLook {
    std::string view_key;
    std::string cell_id;               ///< the method that is shown; empty where every cell failed
    std::string icon;                  ///< the truth, small
    std::string truth, output, error;  ///< error is output minus truth, blue to red over kFirstLookRange
    std::optional<ErrorRegion> worst;  ///< the region with the largest summed error; empty without any
    int cut_left = 0, cut_top = 0;     ///< what is cut out around its worst pixel
    int cut_width = 0, cut_height = 0;
    std::string worst_truth, worst_output;  ///< the cut-out; empty without a region
};

/// The cell that a view's first look shows: the first that succeeded, a bound only where there is no other;
/// null where every cell failed. The results are those of in_ranking_order().
const CellRecord* first_cell(const Results& results, const std::string& view_key);

/// The width of the pictures on a page of so many views.
int first_look_width_px(std::size_t views);

/// The first look of a view, without a cell.
FirstLook first_look(const ViewRecord& view, const ImageF& truth, int width_px);

/// Adds the cell whose image is `output`; nothing is compared where `valid` is 0.
void show_cell(FirstLook& look, const CellRecord& cell, const ImageF& truth, const ImageF& output,
               const Mask& valid, int width_px);

}  // namespace aoscore
