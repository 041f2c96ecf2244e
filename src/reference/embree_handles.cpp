#include "reference/embree_handles.h"

#include "core/error.h"

#include <fmt/format.h>

namespace aoscore {

SceneHandle new_trace_scene(RTCDevice device) {
    SceneHandle handle(rtcNewScene(device));
    rtcSetSceneFlags(handle.get(), RTC_SCENE_FLAG_ROBUST);
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
