#pragma once

#include "core/ratio_table.h"
#include "scene/scene.h"
#include "scene/view_file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

struct MethodsBenchmark {
    int width = 640;
    int height = 360;
    std::uint64_t seed = 1;
    std::vector<std::string> methods;   ///< ids; empty: all
    std::filesystem::path methods_dir;  ///< of the user's own methods; empty: none
};

/// The gain of specialising a shader: every method and preset as it runs (parameters and kernels compiled
/// in, loops written out) beside the plain form of the same shader (all of them uniforms), in turn on one
/// G-buffer. Prints processor milliseconds of both, the median ratio with its quartiles, how far the two
/// pictures differ, and the median over the methods that have kernel tables. Leaves in `table` what a method
/// takes beside a pass that draws the scene's depth alone, and what its form with uniforms takes beside it.
/// Throws internal_error where the pictures differ by more than kSamePicture.
void bench_methods(const Scene& scene, const View& view, const MethodsBenchmark& benchmark,
                   RatioTable& table);

/// Root mean square difference up to which two forms of a shader are taken to give the same picture.
inline constexpr double kSamePicture = 1e-3;

}  // namespace aoscore
