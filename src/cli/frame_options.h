#pragma once

#include "jobs/contest/folder_image.h"
#include "jobs/recorded/recorded_view.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace aoscore {

/// The user's frame without its scene, with its truth and the engine's own ambient occlusion.
struct FrameOptions {
    FrameRequest frame;
    GivenTruthRequest truth;
    std::filesystem::path own;  ///< the engine's own image; empty: none
    VisibilityReading own_reading;

    bool given() const { return !frame.files.empty(); }
};

/// Adds --gbuffer and what belongs to it to a command that has SCENE and options of scenes, which then do not
/// go with it.
void add_recorded_options(CLI::App& app, FrameOptions& options);

/// Reads the frame. Throws usage_error without --truth, and the errors of read_recorded_view().
std::shared_ptr<const RecordedView> read_frame_view(const FrameOptions& options);

/// The engine's own image as a contestant of the view "frame".
OutsideMethod own_contestant(const FrameOptions& options);

}  // namespace aoscore
