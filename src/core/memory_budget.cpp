#include "core/memory_budget.h"

#include "core/error.h"

namespace aoscore {

void MemoryBudget::take(std::size_t bytes, const std::string& where) {
    if (bytes > left_) throw file_error("asks for more memory than a scene may (1 GiB)", where);
    left_ -= bytes;
}

}  // namespace aoscore
