#include "reference/tracer/embree/embree_handles.h"

#include "core/error.h"
#include "reference/truth.h"

#include <fmt/format.h>

namespace aoscore {

std::string tracer_version() {
    return "Embree " RTC_VERSION_STRING;
}

RTCBuildQuality build_quality(TreeEffort effort) {
    return effort == TreeEffort::quick ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_HIGH;
}

SceneHandle new_trace_scene(RTCDevice device, TreeEffort effort) {
    SceneHandle handle(rtcNewScene(device));
    // The filter is that of first_triangles(). Rays that have none are as fast with the flag as without it.
    rtcSetSceneFlags(handle.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcSetSceneBuildQuality(handle.get(), build_quality(effort));
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
