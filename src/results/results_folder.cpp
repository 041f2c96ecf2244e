#include "results/results_folder.h"

#include "core/files.h"

namespace aoscore {

std::filesystem::path results_folder(const std::filesystem::path& named, std::string_view name) {
    return named.empty() ? home_dir() / "reports" / "out" / name : named;
}

}  // namespace aoscore
