#include "stress/stress_key.h"

#include "core/files.h"
#include "core/machine.h"
#include "core/threads.h"

#include <algorithm>
#include <filesystem>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

// Every file below a folder, in the order of their names.
void add_folder(KeyBuilder& key, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) key.text(fs::relative(file, folder).string()).text(read_file(file));
}

}  // namespace

StressKeys::StressKeys(const StressPlan& plan, const std::vector<StressSubject>& subjects,
                       const ScreenRenderer& renderer) {
    KeyBuilder key("stress");
    key.text(renderer.renderer()).text(renderer.version()).text(cpu_name()).value(thread_count());
    key.value(plan.size).value(plan.samples).value(plan.seed);
    for (const char* shared : {"contract", "lib", "gbuffer"})
        add_folder(key, home_dir() / "shaders" / shared);
    for (const StressSubject& subject : subjects) {
        key.text(subject.id);
        for (const MethodDescriptor* part : {subject.method, subject.filter}) {
            if (part != nullptr) add_folder(key, part->folder);
        }
    }
    const StressCase base = stress_case({"base", "", {}}, plan.size);
    key.text(base.scene.digest).camera(base.camera);
    common_ = key.key();
}

std::string StressKeys::of(const StressAxis& axis, const StressSetting& setting,
                           const StressCase& stress) const {
    KeyBuilder key("stress");
    key.input(common_).text(axis.id).text(setting.id).text(setting.label).value(axis.judgement);
    key.text(stress.scene.digest).camera(stress.camera);
    key.value(stress.width).value(stress.height).value(stress.length_scale).value(stress.radius_scale);
    key.value(stress.has_truth).value(stress.performance_presets_only);
    for (const auto& [mode, choice] : unusual_modes(stress.modes)) key.text(mode).text(choice);
    return key.key().hex;
}

}  // namespace aoscore
