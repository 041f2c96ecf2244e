#include "cli/environment_options.h"

#include "cli/number_range.h"
#include "core/error.h"
#include "plan/lit_cells.h"

namespace aoscore {

void add_environment_options(CLI::App& app, EnvironmentOptions& options) {
    app.add_option(
           "--environment", options.environment,
           "Also light surfaces by this environment, and hold them against ray-traced irradiance: sky, a "
           "generated one, or an HDR or EXR file in equirectangular projection, whose middle lies towards "
           "+x, its right half towards +z, its upper edge towards +y")
        ->type_name("sky|FILE");
    app.add_option("--environment-turn", options.turn_deg,
                   "Turn that file so many degrees about the up axis, counterclockwise seen from above [0]")
        ->type_name("DEG")
        ->check(number_in(-360.0, 360.0));
}

void light_view(const EnvironmentOptions& options, const std::vector<MethodDescriptor>& methods,
                ViewPlan& view, std::vector<std::string>& warnings) {
    if (options.turn_deg != 0 && (!options.given() || options.environment == kSkyId))
        throw usage_error("there is no picture to turn", "--environment-turn", "with --environment FILE");
    if (!options.given()) return;
    view.environment = named_environment(options.environment, options.turn_deg);
    light_cells(methods, view, warnings);
}

}  // namespace aoscore
