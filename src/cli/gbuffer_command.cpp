#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/output.h"
#include "jobs/image_output.h"
#include "screen/screen.h"

#include <fmt/format.h>

#include <memory>

namespace aoscore {
namespace {

struct GbufferOptions {
    SceneChoice choice;
    ImageSize size;
    std::filesystem::path out;
};

ExitCode run(const GbufferOptions& options, const GlobalOptions& global) {
    LoadOptions load = options.choice.view.load;
    load.albedo_textures = true;
    const Scene scene = load_with_warnings(options.choice.scene, load);
    const View view = one_view(scene, options.choice.view, options.size);
    const CameraFrame frame(view.camera, options.size.width, options.size.height);
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    const double ms = renderer.draw_gbuffer(frame, gbuffer_inputs());
    const GBufferImages gbuffer = renderer.read_gbuffer();
    write_gbuffer(options.out, gbuffer, view_positions(gbuffer, frame),
                  gbuffer_attributes(scene, view.id, frame, renderer.renderer(), global.command_line));
    log_info(
        fmt::format("{} triangles drawn in {:.1f} ms by {}", scene.triangle_count, ms, renderer.renderer()));
    print_path(options.out);
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_gbuffer_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "gbuffer",
        "Draw the G-buffer of one view into an EXR: Z view depth in metres, depth.Z window depth, N.* "
        "geometric and Ns.* smooth view-space normals, P.* view-space positions, albedo.*, mask.Y; the "
        "camera's "
        "matrices are in the header");
    const auto options = std::make_shared<GbufferOptions>();
    add_scene_options(*app, options->choice);
    add_size_option(*app, options->size);
    add_exr_option(*app, options->out);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
