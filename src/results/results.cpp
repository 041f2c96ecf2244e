#include "results/results.h"

namespace aoscore {

std::string shown_name(const CellRecord& cell) {
    return cell.setting.empty() ? cell.method_label : cell.method_label + ", " + cell.setting;
}

}  // namespace aoscore
