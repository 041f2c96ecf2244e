#pragma once

#include "image/visibility_file.h"
#include "jobs/ground.h"
#include "jobs/recorded/frame_file.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Another program's ray-traced ambient occlusion of a frame, to be the truth.
struct GivenTruthRequest {
    std::filesystem::path file;
    /// A second rendering with other random numbers: the truth is then the mean of the two, and their
    /// difference tells its noise. Empty: none.
    std::filesystem::path second;
    VisibilityReading reading;
    std::optional<double> radius_m;  ///< its AO radius; empty: its header must say
};

/// A view that was recorded: its G-buffer and its truth are files, and there is no scene.
struct RecordedView {
    std::shared_ptr<const Scene> scene;  ///< without triangles; its one view has the frame's camera, and its
                                         ///< digest is that of all pictures
    int width = 0, height = 0;
    double radius_m = 0;
    GBufferImages gbuffer;
    Truth truth;          ///< of one binary query; its standard error is empty where nothing tells it
    Mask valid;           ///< pixels that count: surfaces of the frame that the truth has a value for
    std::string read_as;  ///< how the files were read, in words

    /// The channels of the G-buffer that it has.
    std::set<std::string> channels() const;
};

/// Reads a frame and its truth. `name` becomes the scene's id. Throws file_error, usage_error where the
/// radius is unknown, and sizes_differ.
RecordedView read_recorded_view(const FrameRequest& frame, const GivenTruthRequest& truth,
                                const std::string& name);

/// The pixels of a recorded view that count; both paths are one here, so that nothing can disagree.
Ground recorded_ground(const CameraFrame& frame, const RecordedView& view);

}  // namespace aoscore
