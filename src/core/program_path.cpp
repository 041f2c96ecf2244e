#include "core/program_path.h"

#include "core/error.h"

namespace aoscore {

namespace fs = std::filesystem;

fs::path program_path() {
    return fs::read_symlink("/proc/self/exe");
}

fs::path beside_program(std::string_view name) {
    fs::path path = program_path().parent_path() / name;
    if (!fs::exists(path)) throw internal_error("is not there: build it beside this program", path.string());
    return path;
}

}  // namespace aoscore
