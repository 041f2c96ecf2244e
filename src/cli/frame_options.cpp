#include "cli/frame_options.h"

#include "core/error.h"
#include "core/known_names.h"
#include "image/frame_layout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aoscore {
namespace {

constexpr const char* kOwnId = "own";

/// Integers are read with the coding that the user names; floats ignore it.
void add_coding(CLI::App& app, FrameOptions& options) {
    const auto set = [&options](Coding coding) {
        options.truth.reading.coding = options.own_reading.coding = coding;
    };
    app.add_flag_callback(
           "--srgb", [set] { set(Coding::srgb); }, "Files of 8 or 16 bits are sRGB-coded (--truth, --own)")
        ->needs("--gbuffer");
    app.add_flag_callback(
           "--linear", [set] { set(Coding::linear); }, "Files of 8 or 16 bits are linear (--truth, --own)")
        ->needs("--gbuffer")
        ->excludes("--srgb");
}

}  // namespace

void add_recorded_options(CLI::App& app, FrameOptions& options) {
    app.get_option("scene")->required(false);
    CLI::Option* frame = app.add_option("--gbuffer", options.frame.files,
                                        "A frame without its scene, in place of SCENE: depth, and normals if "
                                        "there are any, in one EXR or one file each; with --truth")
                             ->delimiter(',')
                             ->allow_extra_args(false);
    for (const char* of_scenes : {"scene", "--view", "--views", "--eye", "--unit", "--up", "--size",
                                  "--samples", "--error", "--score-error", "--signals", "--advise"})
        frame->excludes(app.get_option(of_scenes));
    app.add_option("--layout", options.frame.layout,
                   fmt::format("Which program's names its channels have: {} [recognised]",
                               fmt::join(ids_of(frame_layouts()), ", ")))
        ->needs(frame);
    app.add_option(
           "--camera", options.frame.camera,
           "A JSON file with the frame's projection, and how to read its depth and normals [its header]")
        ->needs(frame);
    app.add_option("--truth", options.truth.file, "Ray-traced ambient occlusion of the frame, by any program")
        ->needs(frame);
    app.add_option(
           "--truth-again", options.truth.second,
           "The same with other random numbers: the truth is the mean of the two, and their difference "
           "tells its noise")
        ->needs(frame);
    app.add_option("--truth-channel", options.truth.reading.channel, "Of --truth, such as AO.R [found]")
        ->needs(frame);
    app.add_flag("--invert-truth", options.truth.reading.invert, "--truth holds occlusion, not visibility")
        ->needs(frame);
    app.add_option("--own", options.own,
                   "The engine's own ambient occlusion of the frame, ranked among the methods")
        ->needs(frame);
    app.add_option("--own-channel", options.own_reading.channel, "Of --own [found]")->needs(frame);
    app.add_flag("--invert-own", options.own_reading.invert, "--own holds occlusion, not visibility")
        ->needs(frame);
    add_coding(app, options);
}

std::shared_ptr<const RecordedView> read_frame_view(const FrameOptions& options) {
    if (options.truth.file.empty())
        throw usage_error("a frame without its scene has nothing to trace rays in", "--gbuffer",
                          "with --truth FILE, ray-traced ambient occlusion of the same frame");
    return std::make_shared<const RecordedView>(
        read_recorded_view(options.frame, options.truth, options.frame.files.front().stem().string()));
}

OutsideMethod own_contestant(const FrameOptions& options) {
    OutsideMethod folder;
    folder.folder = options.own.has_parent_path() ? options.own.parent_path() : std::filesystem::path(".");
    folder.method.id = kOwnId;
    folder.method.label = fmt::format("The frame's own ({})", options.own.filename().string());
    folder.method.presets["default"];
    folder.reading = options.own_reading;
    folder.images["frame"] = options.own.filename().string();
    return folder;
}

}  // namespace aoscore
