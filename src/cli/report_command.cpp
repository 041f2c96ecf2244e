#include "cli/command.h"
#include "report/report.h"

#include <fmt/format.h>

#include <memory>

namespace aoscore {

CommandEntry add_report_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app =
        program.add_subcommand("report", "Make the page of earlier results again; prints its path");
    const auto folder = std::make_shared<std::filesystem::path>();
    app->add_option("folder", *folder, "A folder that run or score wrote: results.json and its images")
        ->required();
    return {app, [folder] {
                fmt::print("{}\n", write_report(*folder).string());
                return ExitCode::ok;
            }};
}

}  // namespace aoscore
