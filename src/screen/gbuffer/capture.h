#pragma once

#include "scene/camera.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The index of a picture in a capture, counted from 0.
struct CaptureIndex {
    int frame = 0;  ///< frame in time
    int layer = 0;  ///< layer of depth, 0 in front
    int eye = 0;
};

/// The inputs drawn for a method: channels (image/channels.h) of one or more frames, layers of depth and
/// eyes.
struct Capture {
    /// One camera for each frame and eye, all of one size, beginning with those of the first frame.
    std::vector<CameraFrame> cameras;
    int layers = 1;
    int eyes = 1;
    /// Channels beside those that are always drawn.
    std::set<std::string> channels;

    /// Makes a capture of one frame, one layer and one eye.
    Capture(const CameraFrame& camera, std::set<std::string> asked)
        : cameras{camera}, channels(std::move(asked)) {}

    int frames() const { return static_cast<int>(cameras.size()) / eyes; }
    std::size_t pictures() const { return cameras.size() * static_cast<std::size_t>(layers); }
    const CameraFrame& camera(const CaptureIndex& index) const {
        return cameras[static_cast<std::size_t>(index.frame * eyes + index.eye)];
    }
    /// The picture's place among all of them; layers of one camera are adjacent.
    std::size_t place(const CaptureIndex& index) const {
        return static_cast<std::size_t>((index.frame * eyes + index.eye) * layers + index.layer);
    }
};

}  // namespace aoscore
