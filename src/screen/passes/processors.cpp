#include "screen/passes/processors.h"

#include "screen/passes/line_sweep.h"

namespace aoscore {

const std::vector<Processor>& processors() {
    static const std::vector<Processor> table = {
        {"line_sweep", {"directions", "edge"}, line_sweep, line_sweep_fetches},
    };
    return table;
}

}  // namespace aoscore
