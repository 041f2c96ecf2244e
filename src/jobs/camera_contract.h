#pragma once

#include "reference/truth.h"
#include "scene/camera.h"
#include "screen/screen.h"

#include <cstddef>
#include <string>

namespace aoscore {

/// Says whether ray tracer and rasteriser saw the same surface through every pixel. It catches half pixels,
/// flips, handedness and differing cut-outs before they look like errors of a method.
///
/// Two hits agree when the distance between their tangent planes is at most 1/16 of a pixel's footprint at
/// that depth (a rasteriser snaps vertices to 1/256 of a pixel, which tilts and shifts a small triangle by
/// several times that), or 2e-6 of the farthest coordinate, the rounding of float32 positions, where that is
/// more.
///
/// Pixels at an edge (a neighbour without surface, off the pixel's tangent plane by more than two footprints,
/// or facing elsewhere) may see one surface or the other: where the two disagree the pixel is not valid, but
/// no breach.
struct CameraContract {
    Mask valid;               ///< pixels whose surface both paths see alike
    std::size_t surface = 0;  ///< pixels with surface in either path
    std::size_t valid_count = 0;
    std::size_t edges = 0;        ///< edge pixels among `surface`
    std::size_t disagreeing = 0;  ///< non-edge pixels whose hits differ

    static constexpr double kTolerated = 0.005;
    /// The share of disagreeing pixels among those that were compared away from edges.
    double disagreeing_share() const;
    bool kept() const { return disagreeing_share() <= kTolerated; }
};

/// Says why nothing can be compared on a view with so many surface and valid pixels; empty where something
/// can.
std::string emptiness(std::size_t surface_pixels, std::size_t valid_pixels);

/// Both inputs have the frame's size. `scene_extent_m` is the largest coordinate's magnitude.
CameraContract check_camera_contract(const CameraFrame& frame, const PrimaryHits& hits,
                                     const GBufferImages& gbuffer, double scene_extent_m);

}  // namespace aoscore
