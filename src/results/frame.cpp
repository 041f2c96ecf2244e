#include "results/results.h"

namespace aoscore {

FrameRecord frame_of(double geometry_ms, double lighting_ms, double ao_ms, double filter_ms) {
    constexpr double kSecond_ms = 1000;
    FrameRecord frame;
    frame.geometry_ms = geometry_ms;
    frame.lighting_ms = lighting_ms;
    frame.geometry_lighting_ms = geometry_ms + lighting_ms;
    frame.ao_ms = ao_ms;
    frame.filter_ms = filter_ms;
    frame.frame_ms = frame.geometry_lighting_ms + ao_ms + filter_ms;
    frame.geometry_lighting_share = frame.geometry_lighting_ms / frame.frame_ms;
    frame.ao_share = ao_ms / frame.frame_ms;
    frame.filter_share = filter_ms / frame.frame_ms;
    frame.per_second = kSecond_ms / frame.frame_ms;
    frame.per_second_without_ao = kSecond_ms / frame.geometry_lighting_ms;
    frame.per_second_unfiltered = kSecond_ms / (frame.geometry_lighting_ms + ao_ms);
    return frame;
}

}  // namespace aoscore
