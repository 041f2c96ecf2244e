#pragma once

#include "image/image_frame.h"
#include "image/visibility_file.h"
#include "metrics/analysis/likeness.h"

#include <optional>
#include <span>
#include <vector>

namespace aoscore {

/// A way to read the test that may be the right one: turned; inverted; and then with the curve of sRGB
/// applied or removed, of visibility or of occlusion. Changed values are clamped to [0,1].
struct Reading {
    Orientation turned;
    bool inverted = false;
    void (*curve)(std::span<double>) = nullptr;
    bool curve_of_occlusion = false;
};

/// A reading and its likeness to the truth.
struct Tried {
    Reading reading;
    std::optional<Likeness> likeness;
};

/// Reads the test in several ways at once and measures the likeness of each to the truth, row by row, without
/// a copy of the images. `valid` holds the pixels that count as the test was read; turned, those count that
/// both masks have. The images have one size.
std::vector<Tried> tried_readings(const VisibilityFile& truth, const VisibilityFile& test, const Mask& valid,
                                  std::span<const Reading> readings);

}  // namespace aoscore
