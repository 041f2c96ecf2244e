#include "cli/run_and_page.h"

#include "core/machine.h"
#include "core/output.h"
#include "core/temporary_folder.h"
#include "experiment/experiment.h"
#include "experiment/job_list.h"
#include "page/page.h"
#include "results/advice_text.h"
#include "store/code_digest.h"

#include <optional>
#include <string>
#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// The page of a run, made anew as the run goes on; its path is printed once, when there is one.
class Pages {
  public:
    explicit Pages(fs::path folder) : folder_(std::move(folder)) {}

    /// Writes the page, unless it shows these very results already.
    void write(const fs::path& staged) {
        write_page_unless_shown(staged, folder_ / kName, std::string(code_digest("page")));
        made_ = true;
    }
    void announce() {
        if (!made_ || announced_) return;
        print_path(folder_ / kName);
        flush_output();
        announced_ = true;
    }

  private:
    static constexpr const char* kName = "index.html";
    fs::path folder_;
    bool made_ = false, announced_ = false;
};

}  // namespace

ExitCode run_and_page(ExperimentPlan plan, const std::filesystem::path& folder, const OutcomeOptions& options,
                      const GlobalOptions& global, const std::function<void(const Results&)>& finish) {
    if (!options.jobs.parts_file.empty() && has_score_goal(plan)) {
        throw usage_error("how many rays a ranking needs is decided by all of its cells together",
                          "--score-error", "--samples, --error or --exact, whose rays every part knows");
    }
    if (const auto code = list_or_make_some(
            options.jobs, global.words,
            [&](const std::vector<std::string>& words) { return list_jobs(plan, words); },
            [&](const std::vector<std::string>& keys) { return make_jobs(plan, keys); }))
        return *code;
    require_page_parts();
    Outcome outcome(options);
    plan.baseline = outcome.baseline();
    Pages pages(folder);
    std::optional<TemporaryFolder> own_cache;
    if (has_score_goal(plan)) {
        // The first answer's rays are used again, even where nothing is to be kept.
        if (plan.truth_cache.empty()) plan.truth_cache = own_cache.emplace().path();
        run_experiment(first_answer_of(plan), folder, [&](const fs::path& staged) { pages.write(staged); });
        pages.announce();
    }
    const Results results =
        run_experiment(plan, folder, [&](const fs::path& staged) { pages.write(staged); });
    pages.announce();
    for (const AdviceRecord& advice : results.advice) print_result("\n{}", advice_table(results, advice));
    if (!results.advice.empty() && is_software_renderer(results.gl_renderer))
        print_result("\nMilliseconds are those of a software renderer; fetches carry over to a GPU.\n");
    if (finish) finish(results);
    return outcome.conclude(results);
}

}  // namespace aoscore
