#include "screen/gbuffer/precision.h"

#include "core/error.h"

namespace aoscore {

const std::vector<PrecisionFormat>& precision_formats() {
    static const std::vector<PrecisionFormat> table{
        {Precision::full, "full", "", "", "linear depth, 32-bit float"},
        {Precision::depth_32f, "depth-32f", "WINDOW_FLOAT", "", "window depth, 32-bit float"},
        {Precision::depth_32f_reversed, "depth-32f-reversed", "REVERSED_FLOAT", "",
         "window depth with 1 at the near plane, 32-bit float"},
        {Precision::depth_24, "depth-24", "WINDOW_24", "", "window depth, 24 bits"},
        {Precision::depth_16, "depth-16", "WINDOW_16", "", "window depth, 16 bits"},
        {Precision::linear_16, "linear-16", "LINEAR_16", "", "linear depth, 16 bits"},
        {Precision::linear_16_300m, "linear-16-300m", "LINEAR_16_300M", "",
         "linear depth from the eye to 300 m, 16 bits"},
        {Precision::packed_rgba8, "packed-rgba8", "LINEAR_TWO_BYTES", "TWO_BYTES",
         "linear depth in two bytes, normals in two"},
        {Precision::normal_xy, "normal-xy", "", "X_AND_Y",
         "linear depth, 32-bit float; of normals x and y, and z is taken to be positive"},
        {Precision::positions, "positions", "POSITION", "",
         "view-space positions, 32-bit floats, in place of depth", true},
    };
    return table;
}

const PrecisionFormat& format_of(Precision precision) {
    for (const PrecisionFormat& format : precision_formats()) {
        if (format.precision == precision) return format;
    }
    throw internal_error("precision without a format", "screen/precision.cpp");
}

}  // namespace aoscore
