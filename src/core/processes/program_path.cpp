#include "core/processes/program_path.h"

#include "core/error.h"

namespace aoscore {

namespace fs = std::filesystem;

fs::path program_path() {
    return fs::read_symlink("/proc/self/exe");
}

fs::path beside_program(std::string_view name) {
    const fs::path folder = program_path().parent_path(), built = folder / name;
    if (fs::exists(built)) return built;
    if (fs::path installed = folder.parent_path() / "lib" / "aoscore" / name; fs::exists(installed)) return installed;
    throw internal_error("is not there: build or install it with this program", built.string());
}

}  // namespace aoscore
