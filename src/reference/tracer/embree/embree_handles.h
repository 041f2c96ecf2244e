#pragma once

#include "reference/tracer/ray_tracer.h"

#include <embree3/rtcore.h>

#include <memory>

namespace aoscore {

struct EmbreeReleaser {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

using DeviceHandle = std::unique_ptr<RTCDeviceTy, EmbreeReleaser>;
using SceneHandle = std::unique_ptr<RTCSceneTy, EmbreeReleaser>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, EmbreeReleaser>;

RTCBuildQuality build_quality(TreeEffort effort);

/// An empty scene in which rays are robust. Throws internal_error.
SceneHandle new_trace_scene(RTCDevice device, TreeEffort effort);

/// Throws internal_error if the device has an error pending; `doing` says at what.
void check_embree(RTCDevice device, const char* doing);

}  // namespace aoscore
