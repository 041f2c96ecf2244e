#include "experiment/stress_key.h"

#include "core/files.h"
#include "core/hash.h"

#include <algorithm>
#include <filesystem>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

// Every file below a folder, in the order of their names.
void add_folder(Digest& digest, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) digest.text(fs::relative(file, folder).string()).text(read_file(file));
}

void add_camera(Digest& digest, const Camera& camera) {
    digest.value(camera.projection).value(camera.position).value(camera.target).value(camera.up);
    digest.value(camera.fovy_rad).value(camera.half_height).value(camera.near).value(camera.far);
}

}  // namespace

StressKeys::StressKeys(const StressPlan& plan, const std::vector<StressSubject>& subjects) {
    Digest digest;
    digest.text("stress 1").text(version());
    digest.value(plan.size).value(plan.samples).value(plan.seed);
    for (const char* shared : {"contract", "lib", "gbuffer"})
        add_folder(digest, home_dir() / "shaders" / shared);
    for (const StressSubject& subject : subjects) {
        digest.text(subject.id);
        for (const MethodDescriptor* part : {subject.method, subject.filter}) {
            if (part != nullptr) add_folder(digest, part->folder);
        }
    }
    const StressCase base = stress_case({"base", "", {}}, plan.size);
    digest.text(base.scene.digest);
    add_camera(digest, base.camera);
    common_ = digest.hex();
}

std::string StressKeys::of(const StressAxis& axis, const StressSetting& setting,
                           const StressCase& stress) const {
    Digest digest;
    digest.text(common_).text(axis.id).text(setting.id).text(setting.label).value(axis.judgement);
    digest.text(stress.scene.digest);
    add_camera(digest, stress.camera);
    digest.value(stress.width).value(stress.height).value(stress.length_scale).value(stress.radius_scale);
    digest.value(stress.has_truth).value(stress.performance_presets_only);
    for (const auto& [mode, choice] : unusual_modes(stress.modes)) digest.text(mode).text(choice);
    return digest.hex();
}

}  // namespace aoscore
