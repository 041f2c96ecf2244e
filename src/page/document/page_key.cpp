#include "page/document/page_key.h"

#include "core/files.h"
#include "core/hash.h"
#include "page/document/page_parts.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// The results without members that differ between runs with the same measurements.
Results without_occasion(Results results) {
    results.created_utc.clear();
    results.total_seconds = results.peak_memory_mib = 0;
    results.work = {};
    for (ViewRecord& view : results.views) {
        view.truth_origin.clear();
        view.truth_rays_now = 0;
        view.savings.left_out_triangles = 0;
    }
    return results;
}

void add_files(Digest& digest, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) digest.text(file.filename().string()).text(read_file(file));
}

}  // namespace

std::string page_key(const Results& results, const std::string& code) {
    Digest digest;
    digest.text(code).text(page_style()).text(page_script());
    add_files(digest, page_folder());
    digest.text(to_json(without_occasion(results)).dump());
    return digest.hex();
}

std::string page_key_comment(const std::string& key) {
    return "<!-- aoscore page " + key + " -->\n";
}

bool is_page_of(const fs::path& path, const std::string& key) {
    const std::string comment = page_key_comment(key);
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::streamoff>(comment.size());
    if (!file || file.tellg() < size) return false;
    file.seekg(-size, std::ios::end);
    std::string end(comment.size(), '\0');
    return file.read(end.data(), size) && end == comment;
}

}  // namespace aoscore
