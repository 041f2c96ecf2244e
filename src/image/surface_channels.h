#pragma once

#include <string>

namespace aoscore {

/// The names in a G-buffer's EXR file of one of the surfaces behind one another
/// (screen/gbuffer/surface_layer.h), counted from 0.
struct SurfaceChannels {
    /// Most surfaces that are kept; what lies behind is lost.
    static constexpr int kMost = 16;
    /// The attribute of the file that says how many there are; a picture of nothing has none.
    static constexpr const char* kCount = "aoscore:surfaces";

    std::string depth, triangle_low, triangle_high;

    explicit SurfaceChannels(int layer) {
        const std::string name = "surface" + std::to_string(layer);
        depth = name + ".Z";
        triangle_low = name + ".triangle_low";
        triangle_high = name + ".triangle_high";
    }
};

}  // namespace aoscore
