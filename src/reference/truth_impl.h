#pragma once

#include "reference/tracer/scene_builds.h"
#include "reference/truth.h"

namespace aoscore {

struct ReferenceScene::Impl {
    Impl(const Scene& scene, const TraceBuild& build) : builds(scene, build) {}
    mutable SceneBuilds builds;
};

}  // namespace aoscore
