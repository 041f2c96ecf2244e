#include "cli/job_options.h"

#include "core/output.h"

namespace aoscore {

void add_job_options(CLI::App& app, JobOptions& options) {
    auto* list =
        app.add_flag("--jobs", options.list,
                     "Print the jobs of this command as JSON, with their keys, and make none of them");
    app.add_option("--job", options.only, "Make the artifact of this key alone, and no page")->excludes(list);
}

bool only_lists_or_makes_one(const JobOptions& options, const std::function<nlohmann::json()>& list,
                             const std::function<void(const std::string& key)>& make) {
    if (options.list) {
        print_result("{}\n", list().dump(2));
    } else if (!options.only.empty()) {
        make(options.only);
    }
    return options.list || !options.only.empty();
}

}  // namespace aoscore
