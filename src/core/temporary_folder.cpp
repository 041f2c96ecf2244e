#include "core/temporary_folder.h"

#include "core/error.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace aoscore {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::error_code ec;
    std::string name = (fs::temp_directory_path(ec) / "aoscore-XXXXXX").string();
    if (ec || mkdtemp(name.data()) == nullptr) {
        throw file_error("no folder for temporary files can be made", name,
                         "TMPDIR, a folder that can be written");
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ec;
    fs::remove_all(path_, ec);
}

}  // namespace aoscore
