#include "reference/tracer/embree/embree_handles.h"

#include "core/error.h"
#include "reference/truth.h"

#include <fmt/format.h>

namespace aoscore {

std::string tracer_version() {
    return "Embree " RTC_VERSION_STRING;
}

SceneHandle new_trace_scene(RTCDevice device) {
    SceneHandle handle(rtcNewScene(device));
    // The filter is that of first_triangles(). Rays that have none are as fast with the flag as without it.
    rtcSetSceneFlags(handle.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcSetSceneBuildQuality(handle.get(), RTC_BUILD_QUALITY_HIGH);
    check_embree(device, "making a scene");
    return handle;
}

void check_embree(RTCDevice device, const char* doing) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw internal_error("Embree ran out of memory", doing);
    throw internal_error(fmt::format("Embree reports error {}", static_cast<int>(error)), doing);
}

}  // namespace aoscore
