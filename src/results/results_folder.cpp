#include "results/results_folder.h"

#include "core/folders.h"

namespace aoscore {

std::filesystem::path results_folder(const std::filesystem::path& named, std::string_view name) {
    return named.empty() ? results_dir() / name : named;
}

}  // namespace aoscore
